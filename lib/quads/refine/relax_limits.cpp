#include "refine/relax_limits.hpp"

#include <algorithm>
#include <array>

#include "refine/validity.hpp"
#include "spectral/quad_map.hpp"

namespace quadrille::refine {
namespace {

/// Within this, scaled Jacobians and errors over the tolerance are equal.
constexpr double same_quality = 1e-6;
constexpr double rounding = 1e-12;

/// Margins below 0 break a limit. If one does so only just, margins that are equal to it must do so too.
double limit_for_equals(const std::vector<double>& margins) {
  const bool is_tie = std::any_of(margins.begin(), margins.end(), [](double x) { return x < 0 && x > -same_quality; });
  return is_tie ? same_quality : 0;
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
    const std::vector<Vec2> nodes = element_nodes(mesh, elem);
    mesh.elem_scaled_jacobian[elem] = spectral::quad_scaled_jacobian(mesh.order, nodes.data());
    mesh.elem_jacobian_bound[elem] = spectral::quad_jacobian_lower_bound(mesh.order, nodes.data());
    elems.push_back(elem);
  }
  return elems;
}

std::vector<int> forbidden_elems(const RelaxProblem& problem, const RelaxState& state, RelaxState& trial) {
  const std::vector<int> elems = measure_moved(problem, state, trial);
  const std::vector<double>& before = state.mesh.elem_scaled_jacobian;
  const double floor = *std::min_element(before.begin(), before.end());
  std::vector<double> margins;
  for (const int elem : elems) margins.push_back(trial.mesh.elem_scaled_jacobian[elem] - floor + rounding);
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

}  // namespace quadrille::refine
