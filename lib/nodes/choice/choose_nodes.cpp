#include "choice/choose_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "choice/half_model.hpp"
#include "curve/symmetry_lines.hpp"
#include "features/resolve_features.hpp"
#include "features/small_features.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_phase.hpp"
#include "guide/complete_nodes.hpp"
#include "guide/line_field.hpp"
#include "guide/override_corners.hpp"
#include "guide/resolve_clusters.hpp"
#include "guide/valence.hpp"
#include "mesh/chart_map.hpp"
#include "model/name_rules.hpp"
#include "placement/keep_clearance.hpp"

namespace quadrille::choice {
namespace {

/// The solver that serves both the field tilted at ties and the energy of the nodes, so that the system is factored
/// once. It is made at first use, because most fields need neither.
class SharedSolver {
 public:
  SharedSolver(const Field& field, int num_threads) : field_(field), num_threads_(num_threads) {}
  const std::shared_ptr<galerkin::PhaseSolver>& get() {
    if (!solver_)
      solver_ = std::make_shared<galerkin::PhaseSolver>(field_.mesh, field_.elem_order, num_threads_, field_.alignment);
    return solver_;
  }

 private:
  const Field& field_;
  int num_threads_;
  std::shared_ptr<galerkin::PhaseSolver> solver_;
};

/// The field's zeros as they are, or with ties those of the field tilted at them.
CriticalPoints zeros_of(const field::FieldEvaluator& evaluator, const NodeOptions& options, SharedSolver& solver,
                        Report& report) {
  const CadFace& face = evaluator.field().mesh.face;
  const ties::TieOrbits ties = ties::tie_orbits(face);
  if (options.ties == ties::TiePolicy::choose && !ties.ties.empty()) {
    const auto solve = [&](const auto& data, const std::vector<int>& elem_order, double negligible) {
      solver.get()->set_orders(elem_order);
      return solver.get()->harmonic_parts(data, negligible);
    };
    return ties::choose_at_ties(evaluator, ties, solve, {options.search, options.max_valence}, report);
  }
  CriticalPoints points = guide::find_critical_points(evaluator, options.search, report);
  guide::resolve_clusters(face, options.max_valence, points);
  return points;
}

/// Nodes and corners: by rule where the zeros of the field cannot be isolated.
CriticalPoints nodes_of(const field::FieldEvaluator& evaluator, const NodeOptions& options, SharedSolver& solver,
                        Report& report) {
  try {
    return zeros_of(evaluator, options, solver, report);
  } catch (const ComputeError& error) {
    report.warn(warning::nodes_by_rule,
                fmt::format("{}: corner valences and nodes are chosen by rule instead; look at the layout, and improve "
                            "it with --corner-valence or by editing the nodes",
                            error.what()));
  }
  return guide::line_field_points(evaluator.field().mesh.face, options.max_valence);
}

void add(const Report& part, Report& report) {
  for (const auto& [key, value] : part.entries()) report.set(key, value);
  for (const Report::Warning& warning : part.warnings()) report.warn(warning.code, warning.message);
}

/// The same, searched for once by all that share what is found.
CriticalPoints found_nodes(const field::FieldEvaluator& evaluator, const NodeOptions& options, SharedSolver& solver,
                           Report& report) {
  FoundNodes found{options.search, options.max_valence, options.ties, {}, Report(report.progress())};
  const bool is_shared = options.found != nullptr;
  if (is_shared && options.found->nodes == found) {
    found = *options.found->nodes;
  } else {
    found.points = nodes_of(evaluator, options, solver, found.report);
    if (is_shared) options.found->nodes = found;
  }
  add(found.report, report);
  return std::move(found.points);
}

/// The same for the energy.
placement::NodeEnergy found_energy(const PhaseNodes& nodes, const std::vector<int>& winding_offsets,
                                   const NodeOptions& options, SharedSolver& solver) {
  if (options.found)
    for (const FoundEnergy& found : options.found->energies)
      if (found.nodes == nodes && found.hole_winding_offsets == winding_offsets) return found.energy;
  galerkin::PhaseEnergy computed = solver.get()->energy(nodes, winding_offsets);
  placement::NodeEnergy energy{computed.value, std::move(computed.gradient)};
  if (options.found) options.found->energies.push_back({nodes, winding_offsets, energy});
  return energy;
}

/// By curve: whether nodes keep a distance from it.
std::vector<bool> curves_with_clearance(const CadFace& face, const std::vector<placement::WallClearance>& walls) {
  std::vector<bool> have;
  for (const double clearance : placement::clearance_of_curves(face, walls)) have.push_back(clearance > 0);
  return have;
}

/// Moves nodes that have no position of their own to the least energy, or with `moves_all` all.
void place(const Field& field, const NodeOptions& options, bool moves_all, SharedSolver& solver, CriticalPoints& points,
           Report& report) {
  std::vector<bool> is_free = guide::nodes_without_position(field.mesh.face, points);
  if (moves_all)
    for (std::size_t i = 0; i < is_free.size(); ++i)
      is_free[i] = points.critical_points[i].source != NodeSource::divide;  // the energy draws these into their corners
  if (std::none_of(is_free.begin(), is_free.end(), [](bool free) { return free; })) return;
  const auto of_points = [&, offsets = points.hole_winding_offsets](const CriticalPoints& at) {
    return found_energy(phase_nodes_of(at), offsets, options, solver);
  };
  placement::place_nodes(field.mesh.face, of_points, is_free, options.placement, points, report);
}

/// Moves nodes away from walls with layers, but those of divided corners, which belong near them.
void keep_clearance(const Field& field, const NodeOptions& options, CriticalPoints& points, Report& report) {
  std::vector<bool> may_move;
  for (const CriticalPoint& node : points.critical_points) may_move.push_back(node.source != NodeSource::divide);
  placement::keep_clearance(field.mesh.face, options.walls, options.placement.log_scale, may_move, points, report);
}

/// The nodes of the face for itself, whatever its symmetry lines.
CriticalPoints nodes_of_face(const Field& field, const NodeOptions& options, int num_threads, Report& report,
                             const PartBegins& begin_part) {
  begin_part("search");
  const CadFace& face = field.mesh.face;
  const field::FieldEvaluator evaluator(field);
  SharedSolver solver(field, num_threads);
  CriticalPoints points = found_nodes(evaluator, options, solver, report);
  begin_part("resolve");
  guide::override_corners(face, options.overrides, points);
  if (options.degenerate == guide::DegeneratePolicy::divide) guide::divide_degenerate_corners(face, points);
  guide::report_sharp_corners(face, points, report);
  const topology::LayerCorners layer_corners = topology::layer_corners(face, options.layer_corners);
  const bool is_chosen =
      topology::apply_topology(face, {options.nodes, options.topology, options.max_valence, layer_corners}, points);
  const double feature_size = options.feature_size.value_or(features::automatic_feature_size(face));
  features::resolve_features(face, feature_size, curves_with_clearance(face, options.walls), points, report.progress());
  report.set("feature_size", feature_size);
  guide::require_index_sum(points, face);
  begin_part("place");
  // The zeros of a field follow the directions that are prescribed for it, which the energy of nodes does not know.
  const bool leaves_zeros = options.place == placement::PlaceRule::energy && field.alignment.empty();
  place(field, options, is_chosen || leaves_zeros, solver, points, report);
  keep_clearance(field, options, points, report);
  guide::complete_nodes(evaluator, points);
  points.face = face;
  return points;
}

/// The nodes of the whole of which the face is one half, without their mirror images.
CriticalPoints nodes_of_half(const Field& field, const NodeOptions& options, const curve::SymmetryLine& line,
                             int num_threads, Report& report, const PartBegins& begin_part) {
  Report of_whole(report.progress());
  const HalfModel model(field, options, line);
  const Field whole = model.field_of_whole(num_threads);
  CriticalPoints points =
      model.nodes_of_half(choose_nodes(whole, model.options_of_whole(), num_threads, of_whole, begin_part));
  guide::complete_nodes(field::FieldEvaluator(field), points);
  points.face = field.mesh.face;
  add(of_whole, report);
  return points;
}

/// Whether the corners of the whole on the line have the valences that their angles suggest. Others attract nodes.
bool has_natural_corners(const CadFace& face, const curve::SymmetryLine& line) {
  const auto is_on_line = [&](int c) { return std::binary_search(line.curves.begin(), line.curves.end(), c); };
  for (int j = 0; j < face.num_curves(); ++j) {
    const double quarters = face.joints[j].interior_angle / half_pi;
    if (is_on_line(j) != is_on_line(face.previous_in_loop(j)) &&
        std::lround(2 * quarters) != 2 * std::max(1L, std::lround(quarters)))
      return false;
  }
  return true;
}

/// The nodes of a half for itself, with the line of symmetry as a line of blocks, are those of a grid of the whole too.
/// There their positions have the least energy, unless corners of the whole attract them.
CriticalPoints nodes_beside_line(const Field& field, const curve::SymmetryLine& line, NodeOptions options,
                                 int num_threads, Report& report, const PartBegins& begin_part) {
  if (has_natural_corners(field.mesh.face, line)) options.place = placement::PlaceRule::energy;
  options.placement.symmetry = options.symmetry;
  return nodes_of_face(field, options, num_threads, report, begin_part);
}

/// The scale of the face's chart, of a half that of the whole.
NodeOptions with_scale(const CadFace& face, NodeOptions options) {
  if (!face.chart || options.placement.log_scale) return options;
  options.placement.log_scale = [map = std::make_shared<const mesh::ChartMap>(face)](Vec2 x, Vec2& gradient) {
    return map->log_scale(x, gradient);
  };
  return options;
}

/// Whether the kind of the whole's grid or the number of its nodes is chosen.
bool is_grid_chosen(const CadFace& face, const NodeOptions& options) {
  return options.nodes != topology::NodeRule::by_grid || options.topology != topology::GridKind::by_outline ||
         has_far_field(face);
}

}  // namespace

CriticalPoints choose_nodes(const Field& field, const NodeOptions& given, int num_threads, Report& report,
                            const PartBegins& begin) {
  const NodeOptions options = with_scale(field.mesh.face, given);
  const PartBegins begin_part = [&](const char* name) {
    if (begin) begin(name);
  };
  const CadFace& face = field.mesh.face;
  const std::vector<curve::SymmetryLine> lines =
      curve::symmetry_lines(face, curve::curves_that_fit(face, options.symmetry)).lines;
  if (!curve::is_part_of_whole(lines)) return nodes_of_face(field, options, num_threads, report, begin_part);
  std::string reason;
  try {
    return nodes_of_half(field, options, lines.front(), num_threads, report, begin_part);
  } catch (const OddValenceError& error) {
    if (is_grid_chosen(face, options)) reason = error.what();
  } catch (const ComputeError& error) {
    reason = error.what();
  }
  if (!reason.empty()) {
    const int c = lines.front().curves.front();
    report.warn(
        warning::half_for_itself,
        fmt::format("{}: the nodes are those of the half for itself, with the line of curve {} \"{}\" as a line of "
                    "blocks; another grid of the whole (--topology, --nodes) may have such a line",
                    reason, c, face.curve_names[c]));
  }
  return nodes_beside_line(field, lines.front(), options, num_threads, report, begin_part);
}

}  // namespace quadrille::choice
