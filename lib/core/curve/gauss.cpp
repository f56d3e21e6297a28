#include "curve/gauss.hpp"

#include <cmath>

#include "base/angle.hpp"

namespace quadrille::curve {
namespace {

// Roots of the Legendre polynomial by Newton's method.
template <int n>
GaussRule<n> make_rule() {
  GaussRule<n> rule;
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
    rule.points[i] = x;
    rule.weights[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace

template <int n>
const GaussRule<n>& gauss_rule() {
  static const GaussRule<n> rule = make_rule<n>();
  return rule;
}

template const GaussRule<8>& gauss_rule<8>();
template const GaussRule<16>& gauss_rule<16>();

}  // namespace quadrille::curve
