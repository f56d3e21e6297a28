#include "refine/relax_sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/tolerance.hpp"
#include "refine/inverse_hessian.hpp"
#include "refine/size_energy.hpp"
#include "refine/validity.hpp"
#include "refine/vertex_symmetry.hpp"

namespace quadrille::refine {
namespace {

struct SizeConstants {
  double longest_step = 0.3;  ///< of the prescribed size, by which the ends of an edge move apart at most in one step
  int sweeps_kept = 10;       ///< after which sizes and diagonal blocks are those of the new positions
  /// Relaxation ends after this many sweeps in turn that lower the energy by less than this fraction.
  int slow_sweeps = 2;
  double least_progress = 1e-5;
  double least_slope = 1e-9;  ///< least decrease that the linear model promises, of the energy
  double descent = 1e-4;      ///< least decrease of a step, of that of the linear model
  int max_halvings = 20;      ///< of a step
  int shortenings = 4;        ///< of edges that miss the tolerance of the boundary
  double shorter = 0.95;      ///< than the length at which the distance would be the tolerance
  double heavier = 3;         ///< the weight of the shape of elements that became too skew, over the one before
  int rounds = 6;             ///< of heavier weights
  int move_halvings = 4;      ///< of all moves, if elements are too skew all the same
  double good_scaled_jacobian = 0.7, greatest_loss = 0.1;  ///< elements below both are too skew
};
constexpr SizeConstants size_constants;

/// Moves vertices to the least energy.
class Relaxer {
 public:
  Relaxer(const RelaxProblem& problem, const QuadMesh& shaped, const SizeRelaxation& options);
  void run();
  /// With the vertices that are fixed by now where they began; if that is not possible, with all.
  void begin_again();
  /// Shortens the size of an element along a side.
  void shorten(int elem, int side, double factor) { (side % 2 == 0 ? shorter_[elem].x : shorter_[elem].y) *= factor; }

  SizeEnergy energy;
  VertexMoves moves;
  double value = 0;
  int num_sweeps = 0;

 private:
  void set_sizes();
  EnergyDerivatives begin();
  double longest_step(const VertexMoves& direction) const;
  bool step(EnergyDerivatives& at);

  const RelaxProblem& problem_;
  const SizeRelaxation& options_;
  std::vector<double> size_;   ///< by element
  std::vector<Vec2> shorter_;  ///< by element: factors of the size along s and t
  std::optional<VertexSymmetry> symmetry_;
  InverseHessian inverse_;
};

Relaxer::Relaxer(const RelaxProblem& problem, const QuadMesh& shaped, const SizeRelaxation& options)
    : energy(problem, shaped),
      moves(problem.num_vertices()),
      problem_(problem),
      options_(options),
      shorter_(shaped.num_elems(), {1, 1}),
      inverse_(problem) {
  set_sizes();
  value = energy.value(moves);
}

void Relaxer::set_sizes() {
  const QuadMesh& mesh = problem_.start;
  const std::vector<Vec2> middles = energy.middles(moves);
  std::vector<Vec2> sizes;
  size_.clear();
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int region = mesh.block_region.empty() ? -1 : mesh.block_region[mesh.elem_block[elem]];
    const double size = options_.sizes.at(middles[elem], region);
    const std::vector<Vec2>& limits = options_.greatest_lengths;
    const Vec2 own =
        limits.empty() ? Vec2{size, size} : Vec2{std::min(size, limits[elem].x), std::min(size, limits[elem].y)};
    sizes.push_back({own.x * shorter_[elem].x, own.y * shorter_[elem].y});
    size_.push_back(size);
  }
  energy.set_sizes(sizes);
}

/// Of this direction, at most 1.
double Relaxer::longest_step(const VertexMoves& direction) const {
  const auto move = [&](int v) {
    return problem_.follow.on_boundary(v) < 0 ? direction[v] : direction[v].x * energy.curve_tangents()[v];
  };
  double length = 1;
  for (int elem = 0; elem < problem_.start.num_elems(); ++elem) {
    const auto& vertices = problem_.follow.elem_vertices()[elem];
    for (int c = 0; c < 4; ++c)
      length = std::min(
          length, size_constants.longest_step * size_[elem] / distance(move(vertices[c]), move(vertices[(c + 1) % 4])));
  }
  return length;
}

/// Returns whether the energy became less.
bool Relaxer::step(EnergyDerivatives& at) {
  VertexMoves direction = inverse_.descent(at.gradient);
  symmetry_->average(direction);
  const double slope = inner_product(direction, at.gradient);
  if (!(slope < -size_constants.least_slope * at.value)) return false;
  double length = longest_step(direction);
  for (int halving = 0; halving < size_constants.max_halvings; ++halving, length /= 2) {
    VertexMoves next = moves;
    add_multiple(length, direction, next);
    EnergyDerivatives there = energy.with_derivatives(next);
    if (!(there.value <= at.value + size_constants.descent * length * slope)) continue;
    symmetry_->average(there.gradient);
    VertexMoves change = there.gradient, step = direction;
    add_multiple(-1, at.gradient, change);
    for (Vec2& x : step) x *= length;
    inverse_.add_step(std::move(step), std::move(change));
    moves = std::move(next);
    at = std::move(there);
    return true;
  }
  return false;
}

void Relaxer::begin_again() {
  for (std::size_t v = 0; v < moves.size(); ++v)
    if (problem_.is_fixed[v]) moves[v] = {};
  if (!std::isfinite(energy.value(moves))) moves.assign(moves.size(), {});
}

EnergyDerivatives Relaxer::begin() {
  EnergyDerivatives at = energy.with_derivatives(moves, true);
  if (!symmetry_) symmetry_.emplace(problem_, energy.positions(), at.gradient);
  symmetry_->average(at.gradient);
  inverse_.set_blocks(at.hessian, energy.curve_tangents());
  return at;
}

void Relaxer::run() {
  inverse_.forget();
  set_sizes();
  int slow = 0;
  EnergyDerivatives at = begin();
  for (int sweep = 0; sweep < options_.sweeps && slow < size_constants.slow_sweeps; ++sweep) {
    if (sweep > 0 && sweep % size_constants.sweeps_kept == 0) {
      if (!options_.sizes.is_uniform()) set_sizes();
      at = begin();
    }
    const double before = at.value;
    if (!step(at)) {
      if (inverse_.is_plain()) break;
      inverse_.forget();
      continue;
    }
    ++num_sweeps;
    slow = before - at.value < size_constants.least_progress * before ? slow + 1 : 0;
  }
  value = at.value;
}

/// Edges on the boundary are of the curves at their middles, in the order along these.
void update_curves(const RelaxProblem& problem, const VertexMoves& moves, QuadMesh& mesh) {
  std::vector<std::pair<PartnerPoint, QuadBoundaryEdge>> placed;
  const std::vector<SlidingEdge>& edges = problem.boundary.edges();
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    const auto slide = [&](int end) { return moves[problem.follow.vertex_of(end)].x; };
    const PartnerPoint at = problem.boundary.edge_middle(e, slide(edges[e].from), slide(edges[e].to));
    placed.push_back({at, {edges[e].elem, edges[e].side, at.curve}});
  }
  const auto key = [](const auto& edge) { return std::tuple(edge.first.curve, edge.first.t, edge.second.elem); };
  std::ranges::sort(placed, {}, key);
  const auto is_inside = [&](const QuadBoundaryEdge& edge) { return problem.start.face.is_interface(edge.curve); };
  mesh.boundary_edges.clear();
  for (const auto& [at, edge] : placed)
    if (!is_inside(edge)) mesh.boundary_edges.push_back(edge);
}

/// The mesh of these moves, with its edges inside shaped.
QuadMesh moved_mesh(const RelaxProblem& problem, const SizeRelaxation& options, const VertexMoves& moves) {
  QuadMesh mesh = problem.start;
  mesh.nodes = problem.follow.nodes(moves);
  if (mesh.open_curves.empty()) update_curves(problem, moves, mesh);
  measure_elements(mesh);
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
    const int from = problem.follow.vertex_of(edges[e].from), to = problem.follow.vertex_of(edges[e].to);
    if (moves[from] == Vec2{} && moves[to] == Vec2{}) continue;
    errors.push_back({e, problem.boundary.edge_error(e, moves[from].x, moves[to].x) / tolerance});
  }
  if (std::ranges::none_of(errors, [](const EdgeError& e) { return e.error > 1; })) return {};
  std::erase_if(errors, [](const EdgeError& e) { return e.error < 1 - tolerance::tied; });
  return errors;
}

/// Makes an edge that misses the tolerance shorter, or fixes ends where they began: an end that left a break of its
/// curve at once, both after a few rounds. Returns whether it fixes any.
bool tame_edge(const EdgeError& rough, int round, RelaxProblem& problem, Relaxer& relaxer) {
  const SlidingEdge& edge = problem.boundary.edges()[rough.edge];
  bool is_any = false;
  for (const int end : {edge.from, edge.to}) {
    const int v = problem.follow.vertex_of(end);
    if (problem.is_fixed[v] || !(problem.boundary.vertices()[end].is_at_break || round >= size_constants.shortenings))
      continue;
    problem.is_fixed[v] = is_any = true;
  }
  if (!is_any)
    relaxer.shorten(edge.elem, edge.side,
                    size_constants.shorter * std::pow(rough.error, -1.0 / (problem.start.order + 1)));
  return is_any;
}

/// Relaxes until all edges meet the tolerance.
void relax_within_tolerance(const SizeRelaxation& options, RelaxProblem& problem, Relaxer& relaxer) {
  relaxer.run();
  for (int round = 0;; ++round) {
    const std::vector<EdgeError> rough = rough_edges(problem, relaxer.moves, options.tolerance);
    if (rough.empty()) return;
    bool is_any_fixed = false;
    for (const EdgeError& edge : rough) is_any_fixed |= tame_edge(edge, round, problem, relaxer);
    if (is_any_fixed) relaxer.begin_again();
    relaxer.run();
  }
}

/// By element that may move: whether it is more skew than it has to be, or not proved valid.
std::vector<bool> skew_elements(const QuadMesh& before, const QuadMesh& after, const SizeEnergy& energy) {
  const double least =
      std::min(least_scaled_jacobian(before) - size_constants.greatest_loss, size_constants.good_scaled_jacobian);
  std::vector<bool> is_skew;
  for (int elem = 0; elem < after.num_elems(); ++elem)
    is_skew.push_back(energy.is_free(elem) && (after.elem_scaled_jacobian[elem] < least - tolerance::tied ||
                                               !(after.elem_jacobian_bound[elem] > 0)));
  return is_skew;
}

/// Halves all moves until no element is too skew; if none of them may be made, there are none.
void halve_moves(const RelaxProblem& problem, const SizeRelaxation& options, const QuadMesh& shaped, Relaxer& relaxer,
                 QuadMesh& mesh) {
  for (int halving = 0; halving < size_constants.move_halvings; ++halving) {
    for (Vec2& move : relaxer.moves) move *= 0.5;
    mesh = moved_mesh(problem, options, relaxer.moves);
    if (std::ranges::count(skew_elements(shaped, mesh, relaxer.energy), true) == 0) return;
  }
  relaxer.moves.assign(relaxer.moves.size(), {});
  relaxer.num_sweeps = 0;
  mesh = shaped;
}

}  // namespace

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
  const QuadMesh shaped = result.mesh;
  RelaxProblem problem(mesh, options.frozen_elems, true);
  Relaxer relaxer(problem, shaped, options);
  if (!mesh.is_valid || !std::isfinite(relaxer.value)) return result;
  const double num_free = std::max(1.0, static_cast<double>(mesh.num_elems()));
  result.energy_before = relaxer.value / num_free;
  for (int round = 0; round <= size_constants.rounds; ++round) {
    relax_within_tolerance(options, problem, relaxer);
    result.mesh = moved_mesh(problem, options, relaxer.moves);
    if (round == 0) result.energy_after = relaxer.value / num_free;
    const std::vector<bool> is_skew = skew_elements(shaped, result.mesh, relaxer.energy);
    if (std::ranges::count(is_skew, true) == 0) break;
    if (round == size_constants.rounds) halve_moves(problem, options, shaped, relaxer, result.mesh);
    for (std::size_t elem = 0; elem < is_skew.size(); ++elem)
      if (is_skew[elem]) relaxer.energy.shape_weights[elem] *= size_constants.heavier;
  }
  result.sweeps = relaxer.num_sweeps;
  for (const Vec2 move : relaxer.moves) result.largest_move = std::max(result.largest_move, norm(move));
  return result;
}

}  // namespace quadrille::refine
