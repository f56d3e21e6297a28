// critpoints: finds the irregular nodes of the layout and the valences of the corners from a guiding field.
//
// The steps, each of which changes the result of the one before and keeps the index sum (lib/method.md §3, §5):
//   find_critical_points        zeros, clusters, corners by angle or field, corners that absorb zeros
//   resolve_clusters            clusters become nodes
//   choose_at_ties              replaces both if corners lie near 45 + 90 k degrees
//   line_field_points           replaces all these if the zeros cannot be isolated
//   override_corners            --corner-valence
//   divide_degenerate_corners   --degenerate
//   resolve_features            --feature-size
//   place_nodes                 --place
//   complete_nodes              elements, order
// Each change is recorded. A step whose result has a node that is no zero of the field sets the form `phase`.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "features/automatic_size.hpp"
#include "features/resolve_features.hpp"
#include "field/error_estimate.hpp"
#include "galerkin/phase_energy.hpp"
#include "guide/complete_nodes.hpp"
#include "guide/divide_corners.hpp"
#include "guide/find_critical_points.hpp"
#include "guide/index_sum.hpp"
#include "guide/line_field.hpp"
#include "guide/override_corners.hpp"
#include "guide/resolve_clusters.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "placement/place_nodes.hpp"
#include "ties/choose_at_ties.hpp"

using namespace quadrille;

namespace {

struct NodeOptions {
  guide::SearchOptions search;
  int max_valence = 6;
  std::vector<std::string> corner_valences;
  ties::TiePolicy ties = ties::TiePolicy::choose;
  std::string feature_size = "auto";
  guide::DegeneratePolicy degenerate = guide::DegeneratePolicy::divide;
  placement::PlaceRule place = placement::PlaceRule::keep;
  placement::PlacementOptions placement;

  std::vector<guide::CornerOverride> overrides() const {
    std::vector<guide::CornerOverride> result;
    for (const std::string& text : corner_valences) result.push_back(guide::parse_corner_override(text));
    return result;
  }
};

void declare(cli::Options& o, NodeOptions& options) {
  o.number("--cluster-distance", options.search.cluster_distance, 0, 0.1, "diameters",
           "zeros nearer to each other than this form one cluster, which is replaced by one node or a symmetric set of "
           "nodes, or cancels; so do zeros of opposite index nearer to each other than 0.4 of their distance to the "
           "boundary, if one node or none can replace them; 0: only zeros that cannot be distinguished");
  o.number("--corner-absorb", options.search.corner_absorb, 0, 0.1, "diameters",
           "corners absorb zeros nearer than this where the new valence is admissible; 0: none");
  o.integer("--max-valence", options.max_valence, 5, 12,
            "clusters that would need a node of greater valence are split");
  o.texts("--corner-valence", options.corner_valences, "A:B=V",
          "prescribes V blocks at the corner where the boundary curves A and B meet");
  o.choice("--ties", options.ties,
           "corners within 2 degrees of 45, 135, 225 or 315 degrees: choose their valences by rule, the same on both "
           "sides of the tie; or those of the field, which may not decide them");
  o.choice("--degenerate", options.degenerate,
           "corners too sharp for a block: divide them by a node of valence 3 (midpoint division), or keep them: then "
           "there is no layout");
  o.text("--feature-size", options.feature_size, "auto|L",
         "nodes forced by fillets and holes smaller than this length move onto the boundary or away from it, or "
         "cancel; auto: diameter / 500, or half the mean width of the face if that is less; 0: they stay (unit: file "
         "units; default: auto)");
  o.choice("--place", options.place,
           "keep nodes at the zeros of the field, or move them to the least energy; nodes of split clusters are always "
           "moved, those of divided corners never");
  o.number("--place-weight", options.placement.weight, 0, 100, "1",
           "weight of the boundary-distance term relative to the energy; 0: the energy alone");
}

/// The solver that serves both the field tilted at ties and the energy of the nodes, so that the system is factored
/// once. It is made at first use, because most fields need neither.
class SharedSolver {
 public:
  SharedSolver(const Field& field, int num_threads) : field_(field), num_threads_(num_threads) {}
  const std::shared_ptr<galerkin::PhaseSolver>& get() {
    if (!solver_) solver_ = std::make_shared<galerkin::PhaseSolver>(field_.mesh, field_.elem_order, num_threads_);
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
    const auto solve = [&](const std::vector<field::LiftedData>& data) { return solver.get()->harmonic_parts(data); };
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

void place(const Field& field, const NodeOptions& options, SharedSolver& solver, CriticalPoints& points,
           Report& report) {
  std::vector<bool> is_free = guide::nodes_without_position(field.mesh.face, points);
  if (options.place == placement::PlaceRule::energy)
    for (std::size_t i = 0; i < is_free.size(); ++i)
      is_free[i] = points.critical_points[i].source != NodeSource::divide;  // the energy draws these into their corners
  if (std::none_of(is_free.begin(), is_free.end(), [](bool free) { return free; })) return;
  const auto energy = galerkin::phase_energy_function(solver.get(), {points.hole_winding_offsets});
  const auto of_points = [&](const CriticalPoints& at) {
    galerkin::PhaseEnergy e = energy(phase_nodes_of(at));
    return placement::NodeEnergy{e.value, std::move(e.gradient)};
  };
  placement::place_nodes(field.mesh.face, of_points, is_free, options.placement, points, report);
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  NodeOptions options;
  cli::Tool tool;
  tool.name = "critpoints";
  tool.summary = "chooses the irregular nodes of the layout and the valences of the corners";
  tool.description =
      "Reads a field and finds each of its zeros once, with its index and valence, and the valence of every corner. A "
      "proof shows that none is missing: each element is cut into cells until a bound shows that a cell contains no "
      "zero, or at most one, which is then computed. Each zero has an error bar, from the estimated error of the field "
      "there.\n\n"
      "Zeros that no layout can use are replaced: multiple zeros and zeros nearer to each other than any block are "
      "split symmetrically, merged or cancelled; corners absorb adjacent zeros; nodes of small fillets and holes move "
      "onto the boundary or away from it; corner valences may be prescribed. Where a corner lies within 2 degrees of "
      "45, 135, 225 or 315 degrees, the field does not decide between two valences: they are chosen by rule, and the "
      "nodes are the zeros of the field with its data turned accordingly. Each change is listed in the output with its "
      "reason. Unless \"form\" is \"harmonic\" in the output, the later stages need a field solved for these nodes: "
      "fieldsolve --nodes.\n\n"
      "The sum of 4 - V over the nodes and of 2 - V over the corners must be four times the face's Euler "
      "characteristic (1 less the number of holes); otherwise nothing is written and the exit code is 1.";
  tool.examples = {"critpoints half_disc.field.h5 -o half_disc.crit.json",
                   "critpoints half_disc.field.h5 | jq '.critical_points[] | select(.valence == 3) | .position'",
                   "critpoints --place energy half_disc.field.h5 -o half_disc.placed.crit.json",
                   "critpoints --feature-size 0.1 half_disc.field.h5 | jq '.changes'"};
  tool.options = [&](cli::Options& o) {
    o.input("FIELD", input, "field file of padapt or fieldsolve; - is standard input");
    o.output(output, "file of the nodes and corners; - is standard output");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    const std::vector<guide::CornerOverride> overrides = options.overrides();
    s.begin_phase("read");
    const io::InputFile file = io::read_input(input);
    Field field = io::read_field(file);
    check::require_valid(check::check_field(field, check::CheckDepth::quick), file.name);
    if (field.kind != FieldKind::harmonic)
      throw FormatError(file.name +
                        ": the field is of the phase form, solved for given nodes: critpoints reads harmonic fields");
    if (field.elem_error.empty()) field.elem_error = field::error_estimate(field);
    s.begin_phase("search");
    const field::FieldEvaluator evaluator(field);
    SharedSolver solver(field, s.threads());
    CriticalPoints points = nodes_of(evaluator, options, solver, s.report());
    s.begin_phase("resolve");
    const CadFace& face = field.mesh.face;
    guide::override_corners(face, overrides, points);
    if (options.degenerate == guide::DegeneratePolicy::divide) guide::divide_degenerate_corners(face, points);
    guide::report_sharp_corners(face, points, s.report());
    const double feature_size = features::parse_feature_size(options.feature_size, face);
    features::resolve_features(face, feature_size, points);
    s.report().set("feature_size", feature_size);
    guide::require_index_sum(points);
    s.begin_phase("place");
    place(field, options, solver, points, s.report());
    s.begin_phase("write");
    guide::complete_nodes(evaluator, points);
    s.report().set("critical_points", points.critical_points.size());
    s.report().set("form", enum_name(points.form));
    s.report().set("changes", points.changes.size());
    s.info(fmt::format("{}, {}, index sum {}, {}, form {}",
                       counted(points.critical_points.size() + points.boundary_nodes.size(), "irregular node"),
                       counted(points.corners.size(), "corner"), points.index_sum,
                       counted(points.changes.size(), "change"), enum_name(points.form)));
    points.face = field.mesh.face;
    points.provenance = s.provenance(field.provenance, {file.digest("field")});
    io::write_critical_points(output, points);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
