#include "curve/gauss.hpp"

#include <cmath>

#include "base/angle.hpp"

namespace quadrille {
namespace {

// Roots of the Legendre polynomial by Newton.
GaussRule make_rule() {
  GaussRule rule;
  for (int i = 0; i < GaussRule::num_points; ++i) {
    double x = -std::cos(pi * (i + 0.75) / (GaussRule::num_points + 0.5)), slope = 0;
    for (int iteration = 0; iteration < 8; ++iteration) {
      double p0 = 1, p1 = x;
      for (int n = 2; n <= GaussRule::num_points; ++n) {
        const double p2 = ((2 * n - 1) * x * p1 - (n - 1) * p0) / n;
        p0 = p1, p1 = p2;
      }
      slope = GaussRule::num_points * (x * p1 - p0) / (x * x - 1);
      x -= p1 / slope;
    }
    rule.points[i] = x;
    rule.weights[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace

const GaussRule& gauss_rule() {
  static const GaussRule rule = make_rule();
  return rule;
}

}  // namespace quadrille
