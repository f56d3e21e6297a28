#pragma once
// Gauss-Legendre rules on [-1, 1]; defined here because this folder must not depend on spectral/quadrature.

#include <array>

namespace quadrille::curve {

template <int n>
struct GaussRule {
  std::array<double, n> points, weights;
};

/// n = 8 or 16.
template <int n>
const GaussRule<n>& gauss_rule();

/// Integral of `f` from a to b, exact for polynomials of degree 2 n - 1.
template <int n = 16, class Function>
auto gauss_integral(Function f, double a, double b) {
  const GaussRule<n>& rule = gauss_rule<n>();
  const double middle = (a + b) / 2, half = (b - a) / 2;
  auto sum = rule.weights[0] * f(middle + half * rule.points[0]);
  for (int i = 1; i < n; ++i) sum += rule.weights[i] * f(middle + half * rule.points[i]);
  return half * sum;
}

}  // namespace quadrille::curve
