#include "zeros/cell_zero.hpp"

#include <algorithm>

namespace quadrille::zeros {
namespace {

double outside(Vec2 lambda) { return std::max({-lambda.x, -lambda.y, lambda.x + lambda.y - 1}); }

/// The point of the triangle lambda >= 0, lambda1 + lambda2 <= 1 nearest to p.
Vec2 project(Vec2 p) {
  if (outside(p) <= 0) return p;
  const double s = std::clamp((p.x - p.y + 1) / 2, 0.0, 1.0);
  const std::array<Vec2, 3> on_sides{Vec2{std::clamp(p.x, 0.0, 1.0), 0}, Vec2{0, std::clamp(p.y, 0.0, 1.0)},
                                     Vec2{s, 1 - s}};
  return *std::min_element(on_sides.begin(), on_sides.end(),
                           [&](Vec2 a, Vec2 b) { return norm2(a - p) < norm2(b - p); });
}

Vec2 value(const field::FieldEvaluator& evaluator, const Cell& cell, Vec2 lambda) {
  Vec2 x;
  Mat2 dx_dxi;
  return evaluator.value(cell.elem, cell.xi_at(lambda), x, dx_dxi);
}

Vec2 local_coordinates(const Cell& cell, Vec2 xi) {
  const Vec2 a = cell.xi[1] - cell.xi[0], b = cell.xi[2] - cell.xi[0];
  return inverse(Mat2{a.x, b.x, a.y, b.y}) * (xi - cell.xi[0]);
}

}  // namespace

bool polish_zero(const field::FieldEvaluator& evaluator, int elem, Vec2& xi) {
  double last = 1;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const field::FieldSample s = evaluator.sample(elem, xi);
    const Mat2 dv_dxi = s.dv_dx * s.dx_dxi;
    if (!(std::abs(det(dv_dxi)) > 0)) return false;
    const Vec2 step = inverse(dv_dxi) * s.value;
    const double length = norm(step);
    if (!(length < 1)) return false;
    if (length >= last / 2 && last < 1e-8) return true;  // round-off prevents any further progress
    xi = xi - step;
    last = length;
    if (length < 1e-16) return true;
  }
  return last < 1e-8;
}

bool find_cell_zero(const field::FieldEvaluator& evaluator, const Cell& cell, const Mat2& inverse_jacobian,
                    double contraction, double value_noise, Vec2& xi) {
  const double noise = frobenius_norm(inverse_jacobian) * value_noise, inside_tol = 1e-8 + 4 * noise;
  Vec2 lambda{1.0 / 3, 1.0 / 3};
  Vec2 step = inverse_jacobian * value(evaluator, cell, lambda);
  const double to_vertices = std::sqrt(5.0) / 3;
  if (norm(step) > (1 + contraction) * to_vertices + inside_tol) return false;
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Vec2 next = project(lambda - step);
    const double moved = distance(lambda, next);
    lambda = next;
    step = inverse_jacobian * value(evaluator, cell, lambda);
    if (moved < 1e-7 + noise) break;
  }
  // If the fixed point lies on the cell's edge, the zero of the extended polynomial lies beyond it.
  if (norm(step) > 1e-5 + 10 * noise) return false;
  xi = cell.xi_at(lambda);
  return polish_zero(evaluator, cell.elem, xi) && outside(local_coordinates(cell, xi)) <= inside_tol;
}

}  // namespace quadrille::zeros
