#include "refine/conjugate_descent.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "model/quad_mesh.hpp"

namespace quadrille::refine {
namespace {

/// In one sweep a vertex moves by at most this fraction of the shortest edge at it.
constexpr double longest_step = 0.25;

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

}  // namespace

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
    if (const double length = norm(p[v]); length > longest_step * shortest[v])
      p[v] *= longest_step * shortest[v] / length;
  return p;
}

}  // namespace quadrille::refine
