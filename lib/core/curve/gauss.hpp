#pragma once
// Gauss-Legendre rules on [-1, 1], whose number of points is known to the compiler.

#include <array>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::curve {

template <int n>
struct GaussRule {
  std::array<double, n> points, weights;

  /// The points are roots of the Legendre polynomial, by Newton's method.
  GaussRule() {
    for (int i = 0; i < n; ++i) {
      double x = -std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 0;
      for (int iteration = 0; iteration < 8; ++iteration) {
        double p0 = 1, p1 = x;
        for (int k = 2; k <= n; ++k) {
          const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
          p0 = p1, p1 = p2;
        }
        slope = n * (x * p1 - p0) / (x * x - 1);
        x -= p1 / slope;
      }
      points[i] = x;
      weights[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

template <int n>
const GaussRule<n>& gauss_rule() {
  static const GaussRule<n> rule;
  return rule;
}

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
