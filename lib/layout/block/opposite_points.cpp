#include "block/opposite_points.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::block {
namespace {

/// The distance by which b's point lies ahead of a's, times the length of the sum of tangents.
double lead(const DirectedCurve& a, const DirectedCurve& b, double middle, double d) {
  const curve::ChainPoint p = a.at(middle - d / 2), q = b.at(middle + d / 2);
  return dot(q.position - p.position, p.tangent + q.tangent);
}

}  // namespace

std::optional<double> opposite_point_offset(const DirectedCurve& a, const DirectedCurve& b, double middle) {
  constexpr double margin = 0.05;
  constexpr int steps = 64;
  const double widest = 2 * std::min(middle - margin, 1 - margin - middle);
  const double at_zero = lead(a, b, middle, 0);
  if (at_zero == 0) return 0;
  const double direction = at_zero > 0 ? -1 : 1;
  double low = 0;
  for (int i = 1; i <= steps; ++i) {
    double high = widest * i / steps;
    if (lead(a, b, middle, direction * high) * at_zero > 0) {
      low = high;
      continue;
    }
    for (int k = 0; k < 50; ++k) {
      const double half = (low + high) / 2;
      (lead(a, b, middle, direction * half) * at_zero > 0 ? low : high) = half;
    }
    return direction * (low + high) / 2;
  }
  return std::nullopt;
}

}  // namespace quadrille::block
