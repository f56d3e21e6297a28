#include "refine/relax.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/tolerance.hpp"
#include "model/quad_mesh.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

struct RelaxConstants {
  double longest_step = 0.25;  ///< of the shortest edge at a vertex, by which it moves at most in one sweep
  /// Relaxation ends after a sweep that lowers the energy by less than this fraction of its excess over its least
  /// value, 1 for each element.
  double least_progress = 1e-7;
  int max_halvings = 6;  ///< of a step
  int max_resets = 12;   ///< of moves in one trial
  double greatest_first_length = 8;
  double rounding = 1e-12;  ///< of scaled Jacobians
};
constexpr RelaxConstants relax_constants;

/// Margins below 0 break a limit. If one does so only just, margins that are equal to it must do so too.
double limit_for_equals(const std::vector<double>& margins) {
  const bool is_tie =
      std::any_of(margins.begin(), margins.end(), [](double x) { return x < 0 && x > -tolerance::tied; });
  return is_tie ? tolerance::tied : 0;
}

/// Measures the elements with a vertex that has moved, copies the measures of the others, and returns the former.
std::vector<int> measure_moved(const RelaxProblem& problem, const RelaxState& state, RelaxState& trial) {
  std::vector<int> elems;
  QuadMesh& mesh = trial.mesh;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const auto& vertices = problem.follow.elem_vertices()[elem];
    const bool is_moved =
        std::any_of(vertices.begin(), vertices.end(), [&](int v) { return trial.moves[v] != state.moves[v]; });
    if (!is_moved) {
      mesh.elem_scaled_jacobian[elem] = state.mesh.elem_scaled_jacobian[elem];
      mesh.elem_jacobian_bound[elem] = state.mesh.elem_jacobian_bound[elem];
      continue;
    }
    measure_element(mesh, elem);
    elems.push_back(elem);
  }
  return elems;
}

std::vector<int> forbidden_elems(const RelaxProblem& problem, const RelaxState& state, RelaxState& trial) {
  const std::vector<int> elems = measure_moved(problem, state, trial);
  const std::vector<double>& before = state.mesh.elem_scaled_jacobian;
  const double floor = *std::min_element(before.begin(), before.end());
  std::vector<double> margins;
  for (const int elem : elems)
    margins.push_back(trial.mesh.elem_scaled_jacobian[elem] - floor + relax_constants.rounding);
  const double limit = limit_for_equals(margins);
  std::vector<int> forbidden;
  for (std::size_t i = 0; i < elems.size(); ++i)
    if (margins[i] < limit || !(trial.mesh.elem_jacobian_bound[elems[i]] > 0)) forbidden.push_back(elems[i]);
  return forbidden;
}

std::array<int, 2> end_vertices(const RelaxProblem& problem, int edge) {
  const SlidingEdge& e = problem.boundary.edges()[edge];
  return {problem.follow.vertex_of(e.from), problem.follow.vertex_of(e.to)};
}

std::vector<int> forbidden_edges(const RelaxProblem& problem, const RelaxState& state, const RelaxState& trial,
                                 double tolerance) {
  std::vector<int> edges, forbidden;
  std::vector<double> margins;
  const auto has_moved = [&](int v) { return trial.moves[v] != state.moves[v]; };
  for (int e = 0; e < static_cast<int>(problem.boundary.edges().size()); ++e) {
    const auto [from, to] = end_vertices(problem, e);
    if (!has_moved(from) && !has_moved(to)) continue;
    edges.push_back(e);
    margins.push_back(1 - problem.boundary.edge_error(e, trial.moves[from].x, trial.moves[to].x) / tolerance);
  }
  const double limit = limit_for_equals(margins);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (margins[i] < limit) forbidden.push_back(edges[i]);
  return forbidden;
}

using Symmetric = std::array<double, 3>;  ///< xx, xy, yy

struct Derivatives {
  VertexMoves gradient;
  std::vector<Symmetric> hessian;  ///< diagonal blocks
};

double dot_of(const VertexMoves& a, const VertexMoves& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

Vec2 solve(const Symmetric& h, Vec2 g) {
  const double det = h[0] * h[2] - h[1] * h[1];
  return det > 0 ? Vec2{h[2] * g.x - h[1] * g.y, h[0] * g.y - h[1] * g.x} / det : Vec2{};
}

Derivatives derivatives(const RelaxProblem& problem, const std::vector<Vec2>& nodes) {
  Derivatives sum{VertexMoves(problem.num_vertices()), std::vector<Symmetric>(problem.num_vertices(), Symmetric{})};
  for (int elem = 0; elem < problem.start.num_elems(); ++elem) {
    const ElementEnergy e = problem.energy.with_derivatives(elem, nodes);
    for (int c = 0; c < 4; ++c) {
      const int v = problem.follow.elem_vertices()[elem][c];
      sum.gradient[v] += e.gradient[c];
      for (int k = 0; k < 3; ++k) sum.hessian[v][k] += e.hessian[c][k];
    }
  }
  return sum;
}

/// Restricts the derivatives to admissible moves: 0 for fixed vertices, along the curve for those on the boundary.
void reduce(const RelaxProblem& problem, const VertexMoves& moves, Derivatives& d) {
  for (int v = 0; v < problem.num_vertices(); ++v) {
    if (problem.is_fixed[v]) d.gradient[v] = {};
    const int b = problem.follow.on_boundary(v);
    if (b < 0) continue;
    const Vec2 t = problem.boundary.at(b, moves[v].x).tangent;
    Symmetric& h = d.hessian[v];
    h = {h[0] * t.x * t.x + 2 * h[1] * t.x * t.y + h[2] * t.y * t.y, 0, 1};
    d.gradient[v] = {dot(d.gradient[v], t), 0};
  }
}

/// By vertex: length of the shortest edge at it.
std::vector<double> shortest_edges(const RelaxProblem& problem, const std::vector<Vec2>& positions) {
  std::vector<double> shortest(problem.num_vertices(), std::numeric_limits<double>::infinity());
  const QuadMesh& mesh = problem.start;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const auto& vertices = problem.follow.elem_vertices()[elem];
    for (int c = 0; c < 4; ++c) {
      const double length =
          distance(positions[side_start(mesh, elem, c)], positions[side_start(mesh, elem, (c + 1) % 4)]);
      for (const int v : {vertices[c], vertices[(c + 1) % 4]}) shortest[v] = std::min(shortest[v], length);
    }
  }
  return shortest;
}

/// Resets the moves that break a limit, and accepts the others as the new state if the energy decreases.
bool accept(const RelaxProblem& problem, double tolerance, VertexMoves moves, RelaxState& state) {
  RelaxState trial{state.mesh, std::move(moves), 0};
  for (int round = 0; round < relax_constants.max_resets; ++round) {
    trial.mesh.nodes = problem.follow.nodes(trial.moves);
    trial.energy = problem.total_energy(trial.mesh.nodes);
    if (!(trial.energy < state.energy)) return false;
    if (reset_forbidden_moves(problem, state, tolerance, trial)) continue;
    state = std::move(trial);
    return true;
  }
  return false;
}

/// One sweep: a step along `direction`, halved until it is accepted; false if no vertex could be moved. `first_length`
/// is the first step length of the line search, and is adapted for the next sweep.
bool step(const RelaxProblem& problem, double tolerance, const VertexMoves& direction, double& first_length,
          RelaxState& state) {
  double length = first_length;
  for (int halving = 0; halving < relax_constants.max_halvings; ++halving, length /= 2) {
    VertexMoves moves = state.moves;
    for (std::size_t v = 0; v < moves.size(); ++v) moves[v] += length * direction[v];
    if (!accept(problem, tolerance, std::move(moves), state)) continue;
    first_length = std::min(halving == 0 ? 2 * length : length, relax_constants.greatest_first_length);
    return true;
  }
  return false;
}

}  // namespace

bool reset_forbidden_moves(const RelaxProblem& problem, const RelaxState& state, double tolerance, RelaxState& trial) {
  std::vector<bool> is_forbidden(trial.moves.size(), false);
  for (const int elem : forbidden_elems(problem, state, trial))
    for (const int v : problem.follow.elem_vertices()[elem]) is_forbidden[v] = true;
  for (const int edge : forbidden_edges(problem, state, trial, tolerance))
    for (const int v : end_vertices(problem, edge)) is_forbidden[v] = true;
  bool is_any = false;
  for (std::size_t v = 0; v < trial.moves.size(); ++v)
    if (is_forbidden[v] && trial.moves[v] != state.moves[v]) trial.moves[v] = state.moves[v], is_any = true;
  return is_any;
}

VertexMoves ConjugateDescent::next(const std::vector<Vec2>& nodes, const VertexMoves& moves) {
  Derivatives d = derivatives(*problem_, nodes);
  reduce(*problem_, moves, d);
  VertexMoves& gradient = d.gradient;
  VertexMoves descent(gradient.size());
  for (std::size_t v = 0; v < gradient.size(); ++v) descent[v] = -solve(d.hessian[v], gradient[v]);

  const double slope = dot_of(gradient, descent);
  double beta = 0;
  if (last_slope_ < 0) {
    VertexMoves change = gradient;
    for (std::size_t v = 0; v < change.size(); ++v) change[v] -= last_gradient_[v];
    beta = std::max(0.0, dot_of(change, descent) / last_slope_);  // Polak-Ribiere
  }
  VertexMoves p = descent;
  if (beta > 0)
    for (std::size_t v = 0; v < p.size(); ++v) p[v] += beta * last_direction_[v];
  if (dot_of(p, gradient) >= 0) p = descent;
  last_gradient_ = std::move(gradient);
  last_slope_ = slope;
  last_direction_ = p;

  const std::vector<double> shortest = shortest_edges(*problem_, nodes);
  for (std::size_t v = 0; v < p.size(); ++v)
    if (const double length = norm(p[v]), most = relax_constants.longest_step * shortest[v]; length > most)
      p[v] *= most / length;
  return p;
}

RelaxOutcome relax(QuadMesh& mesh, const RelaxOptions& options) {
  if (options.sweeps == 0 || !mesh.is_valid) return {};
  const RelaxProblem problem(mesh, options.frozen_elems);
  ConjugateDescent descent(problem);
  RelaxState state{mesh, VertexMoves(problem.num_vertices()), problem.total_energy(mesh.nodes)};
  RelaxOutcome outcome;
  const double num_elems = mesh.num_elems(), energy_before = state.energy;
  double first_length = 1;
  const Progress::Part part(options.progress, "sweeps", options.sweeps, Progress::Total::bound);
  for (int sweep = 0; sweep < options.sweeps; ++sweep, part.advance()) {
    const double before = state.energy;
    if (!step(problem, options.tolerance, descent.next(state.mesh.nodes, state.moves), first_length, state)) break;
    ++outcome.sweeps;
    if (before - state.energy < relax_constants.least_progress * (before - num_elems)) break;
  }
  const double per_elem = 1.0 / num_elems;
  outcome.energy_before = energy_before * per_elem;
  outcome.energy_after = state.energy * per_elem;
  for (const Vec2 move : state.moves) outcome.largest_move = std::max(outcome.largest_move, norm(move));
  mesh = std::move(state.mesh);
  measure_elements(mesh);
  return outcome;
}

void relax_and_report(QuadMesh& mesh, const RelaxOptions& options, Report& report) {
  report.set("relax.least_scaled_jacobian_before", least_scaled_jacobian(mesh));
  report.set("relax.mean_scaled_jacobian_before", mean_scaled_jacobian(mesh));
  const RelaxOutcome outcome = relax(mesh, options);
  report.set("relax.sweeps", outcome.sweeps);
  report.set("relax.energy_before", outcome.energy_before);
  report.set("relax.energy_after", outcome.energy_after);
  report.set("relax.largest_move", outcome.largest_move);
}

}  // namespace quadrille::refine
