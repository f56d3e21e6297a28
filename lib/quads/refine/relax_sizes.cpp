#include "refine/relax_sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/tolerance.hpp"
#include "refine/even_vertices.hpp"
#include "refine/joint_vertices.hpp"
#include "refine/size_relaxer.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

struct SizeConstants {
  int shortenings = 12;   ///< of edges that miss the tolerance of the boundary
  double shorter = 0.95;  ///< than the length at which the distance would be the tolerance
  int move_halvings = 4;  ///< of all moves, if elements are not valid or too skew
  double hopeless = 4;    ///< energy with vertices at joints, over that without, above which they are not put there
};
constexpr SizeConstants size_constants;

/// Edges on the boundary and on interfaces are of the curves at their middles, in the order along these.
void update_curves(const RelaxProblem& problem, const VertexMoves& moves, QuadMesh& mesh) {
  std::vector<std::pair<PartnerPoint, QuadBoundaryEdge>> placed;
  const std::vector<SlidingEdge>& edges = problem.boundary.edges();
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    const auto slide = [&](int end) { return problem.follow.slide(end, moves); };
    const PartnerPoint at = problem.boundary.edge_middle(e, slide(edges[e].from), slide(edges[e].to));
    placed.push_back({at, {edges[e].elem, edges[e].side, at.curve}});
  }
  const auto key = [](const auto& edge) { return std::tuple(edge.first.curve, edge.first.t, edge.second.elem); };
  std::ranges::sort(placed, {}, key);
  const auto is_inside = [&](int curve) {
    return mesh.face.is_interface(curve) && !std::ranges::binary_search(mesh.open_curves, curve);
  };
  mesh.boundary_edges.clear(), mesh.interface_edges.clear();
  for (const auto& [at, edge] : placed)
    (is_inside(edge.curve) ? mesh.interface_edges : mesh.boundary_edges).push_back(edge);
}

/// The mesh of these moves, with its edges inside shaped.
QuadMesh moved_mesh(const RelaxProblem& problem, const SizeRelaxation& options, const VertexMoves& moves) {
  QuadMesh mesh = problem.start;
  mesh.nodes = problem.follow.nodes(moves);
  update_curves(problem, moves, mesh);
  shape_inner_edges(mesh, options.inner_edges, options.kept_elems);
  return mesh;
}

/// An edge on a curve with a moved end, and its distance from the curve over the tolerance.
struct EdgeError {
  int edge = 0;
  double error = 0;
};

/// Those that miss the tolerance. Of edges that miss it by nearly nothing equal ones do so together.
std::vector<EdgeError> rough_edges(const RelaxProblem& problem, const VertexMoves& moves, double tolerance) {
  std::vector<EdgeError> errors;
  const std::vector<SlidingEdge>& edges = problem.boundary.edges();
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    const double from = problem.follow.slide(edges[e].from, moves), to = problem.follow.slide(edges[e].to, moves);
    if (from == 0 && to == 0) continue;
    errors.push_back({e, problem.boundary.edge_error(e, from, to) / tolerance});
  }
  if (std::ranges::none_of(errors, [](const EdgeError& e) { return e.error > 1; })) return {};
  std::erase_if(errors, [](const EdgeError& e) { return e.error < 1 - tolerance::tied; });
  return errors;
}

/// Makes the element at an edge that misses the tolerance shorter.
void shorten(const EdgeError& rough, const RelaxProblem& problem, SizeRelaxer& relaxer) {
  const SlidingEdge& edge = problem.boundary.edges()[rough.edge];
  relaxer.shorter(edge.elem, edge.side) *=
      size_constants.shorter * std::pow(rough.error, -1.0 / (problem.start.order + 1));
}

/// Makes an edge that misses the tolerance shorter, or fixes ends where they began: an end that left a break of its
/// curve at once, both after a few rounds. Returns whether it fixes any.
bool tame_edge(const EdgeError& rough, int round, RelaxProblem& problem, SizeRelaxer& relaxer) {
  const SlidingEdge& edge = problem.boundary.edges()[rough.edge];
  const bool may_begin_again = problem.boundary.free_joints().empty();  // else another vertex may be there
  bool is_any = false;
  for (const int end : {edge.from, edge.to}) {
    const int v = problem.follow.vertex_of(end);
    const bool is_off_break = may_begin_again && problem.boundary.vertices()[end].is_at_break;
    if (problem.is_fixed[v] || !(is_off_break || round >= size_constants.shortenings)) continue;
    problem.fix_vertex(v);
    is_any = true;
  }
  if (!is_any) shorten(rough, problem, relaxer);
  return is_any;
}

/// Where an end was fixed since, elements have their sizes again.
void lengthen(const std::vector<bool>& was_fixed, const RelaxProblem& problem, SizeRelaxer& relaxer) {
  const auto is_fixed_since = [&](int end) {
    const int v = problem.follow.vertex_of(end);
    return problem.is_fixed[v] && !was_fixed[v];
  };
  for (const SlidingEdge& edge : problem.boundary.edges())
    if (is_fixed_since(edge.from) || is_fixed_since(edge.to)) relaxer.shorter(edge.elem, edge.side) = 1;
}

/// Relaxes until all edges meet the tolerance. Returns whether that is possible with an energy of at most `most`.
bool relax_within_tolerance(const SizeRelaxation& options, double most, RelaxProblem& problem, SizeRelaxer& relaxer) {
  const std::vector<bool> was_fixed = problem.is_fixed;
  relaxer.run();
  for (int round = 0; relaxer.value <= most; ++round) {
    const std::vector<EdgeError> rough = rough_edges(problem, relaxer.moves, options.tolerance);
    if (rough.empty()) return true;
    if (relaxer.is_exhausted()) return false;
    bool is_any_fixed = false;
    for (const EdgeError& edge : rough) is_any_fixed |= tame_edge(edge, round, problem, relaxer);
    if (is_any_fixed && round >= size_constants.shortenings) lengthen(was_fixed, problem, relaxer);
    if (is_any_fixed ? !relaxer.begin_again() : round >= size_constants.shortenings) return false;
    relaxer.run();
  }
  return false;
}

/// Relaxes as if curves went on smoothly at the joints that vertices may slide off, so that there are about as many
/// elements between them as there have to be.
void relax_across_joints(const SizeRelaxation& options, const RelaxProblem& problem, SizeRelaxer& relaxer) {
  const auto passes_joint = [&](const EdgeError& rough) {
    const SlidingEdge& edge = problem.boundary.edges()[rough.edge];
    const auto slide = [&](int end) { return problem.follow.slide(end, relaxer.moves); };
    return problem.boundary.passes_free_joint(rough.edge, slide(edge.from), slide(edge.to));
  };
  relaxer.run();
  for (int round = 0; round < size_constants.shortenings; ++round) {
    std::vector<EdgeError> rough = rough_edges(problem, relaxer.moves, options.tolerance);
    std::erase_if(rough, passes_joint);
    if (rough.empty() || relaxer.is_exhausted()) return;
    for (const EdgeError& edge : rough) shorten(edge, problem, relaxer);
    relaxer.run();
  }
}

/// Whether an element that may move is not proved valid, or a goal of shapes makes it more skew than the worst one was.
bool is_any_worse(const SizeRelaxation& options, const QuadMesh& before, const QuadMesh& after,
                  const SizeEnergy& energy) {
  const double least = options.keeps_lengths ? least_scaled_jacobian(before) - tolerance::tied : 0;
  for (int elem = 0; elem < after.num_elems(); ++elem)
    if (energy.is_free(elem) && !(after.elem_jacobian_bound[elem] > 0 && after.elem_scaled_jacobian[elem] >= least))
      return true;
  return false;
}

/// Halves all moves until no element is worse; if none of them may be made, there are none.
void halve_moves(const RelaxProblem& problem, const SizeRelaxation& options, const QuadMesh& shaped,
                 SizeRelaxer& relaxer, QuadMesh& mesh) {
  for (int halving = 0; halving < size_constants.move_halvings; ++halving) {
    for (Vec2& move : relaxer.moves) move *= 0.5;
    mesh = moved_mesh(problem, options, relaxer.moves);
    if (!is_any_worse(options, shaped, mesh, relaxer.energy)) return;
  }
  relaxer.moves.assign(relaxer.moves.size(), {});
  relaxer.num_sweeps = 0;
  mesh = shaped;
}

}  // namespace

VertexRelaxation::VertexRelaxation(const QuadMesh& mesh, const QuadMesh& shaped, const SizeRelaxation& options,
                                   SlidesOff slides_off)
    : options_(options),
      shaped_(shaped),
      problem_(mesh, options_.frozen_elems, slides_off),
      relaxer_(problem_, shaped_, options_),
      passes_joints_(!problem_.boundary.free_joints().empty()),
      energy_before_(relaxer_.value / std::max(1, mesh.num_elems())) {}

bool VertexRelaxation::begin() {
  is_begun_ = true;
  if (options_.start) relaxer_.begin_at(*options_.start);
  // What edges and elements need is settled while vertices are nearly in place; at last they are put there.
  relaxer_.least_progress = coarse_progress;
  if (!relaxer_.hold(even_vertices(problem_, relaxer_.moves, options_.even_curves), problem_)) return false;
  if (!passes_joints_) return true;
  relax_across_joints(options_, problem_, relaxer_);
  most_value_ = size_constants.hopeless * relaxer_.value;
  return relaxer_.hold(vertices_at_joints(problem_, relaxer_.moves, options_.tolerance), problem_);
}

bool VertexRelaxation::run(double least_progress, SizeRelaxed& result) {
  if (!std::isfinite(energy_before_)) return true;
  if (is_begun_)
    relaxer_.least_progress = std::min(relaxer_.least_progress, least_progress);
  else if (!begin())
    return relaxer_.is_exhausted();
  SizeRelaxed relaxed{shaped_, 0, energy_before_};
  if (!relax_within_tolerance(options_, most_value_, problem_, relaxer_)) return relaxer_.is_exhausted();
  if (std::exchange(relaxer_.least_progress, std::min(relaxer_.least_progress, least_progress)) > least_progress &&
      !relax_within_tolerance(options_, most_value_, problem_, relaxer_))
    return relaxer_.is_exhausted();
  relaxed.mesh = moved_mesh(problem_, options_, relaxer_.moves);
  relaxed.energy_after = relaxer_.value / std::max(1, shaped_.num_elems());
  if (is_any_worse(options_, shaped_, relaxed.mesh, relaxer_.energy)) {
    if (passes_joints_ || !options_.even_curves.empty()) return relaxer_.is_exhausted();
    halve_moves(problem_, options_, shaped_, relaxer_, relaxed.mesh);
    relaxed.energy_after = relaxer_.energy.value(relaxer_.moves) / std::max(1, shaped_.num_elems());
  }
  relaxed.sweeps = relaxer_.num_sweeps;
  for (const Vec2 move : relaxer_.moves) relaxed.largest_move = std::max(relaxed.largest_move, norm(move));
  relaxed.relaxation = std::move(result.relaxation);
  result = std::move(relaxed);
  return true;
}

void report_relaxation(Report& report, const QuadMesh& before, const SizeRelaxed& relaxed) {
  report.set("relax.least_scaled_jacobian_before", least_scaled_jacobian(before));
  report.set("relax.mean_scaled_jacobian_before", mean_scaled_jacobian(before));
  report.set("relax.sweeps", relaxed.sweeps);
  report.set("relax.energy_before", relaxed.energy_before);
  report.set("relax.energy_after", relaxed.energy_after);
  report.set("relax.largest_move", relaxed.largest_move);
}

SizeRelaxed relax_to_sizes(const QuadMesh& mesh, const SizeRelaxation& options) {
  SizeRelaxed result{mesh};
  shape_inner_edges(result.mesh, options.inner_edges, options.kept_elems);
  if (!result.mesh.is_valid) return result;
  for (const SlidesOff slides_off : {SlidesOff::joints, SlidesOff::breaks}) {
    if (slides_off == SlidesOff::joints && options.slides_off == SlidesOff::breaks) continue;
    result.relaxation = std::make_shared<VertexRelaxation>(mesh, result.mesh, options, slides_off);
    if (result.relaxation->run(options.least_progress, result)) return result;
  }
  if (options.even_curves.empty()) return result;
  // Without equal lengths along any curve the mesh can still be relaxed; report_even_counts warns then.
  SizeRelaxation without_even_curves = options;
  without_even_curves.even_curves.clear();
  return relax_to_sizes(mesh, without_even_curves);
}

}  // namespace quadrille::refine
