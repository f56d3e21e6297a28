#pragma once
// The 16-point Gauss-Legendre rule on [-1, 1]; here because spectral/quadrature is no neighbour of this folder.

#include <array>

namespace quadrille {

struct GaussRule {
  static constexpr int num_points = 16;
  std::array<double, num_points> points, weights;
};

const GaussRule& gauss_rule();

/// Integral of `f` from a to b, exact for polynomials of degree 31.
template <class Function>
auto gauss_integral(Function f, double a, double b) {
  const GaussRule& rule = gauss_rule();
  const double middle = (a + b) / 2, half = (b - a) / 2;
  auto sum = rule.weights[0] * f(middle + half * rule.points[0]);
  for (int i = 1; i < GaussRule::num_points; ++i) sum += rule.weights[i] * f(middle + half * rule.points[i]);
  return half * sum;
}

}  // namespace quadrille
