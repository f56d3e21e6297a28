#include "triangulate/arc_length_table.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::triangulate {
namespace {

constexpr int max_depth = 12;
constexpr double round_off = 1e-15;

/// cos(pi j k / n) for j, k = 0..n, with j k reduced modulo 2 n.
template <int n>
const std::array<double, 2 * n>& cosines() {
  static const auto table = [] {
    std::array<double, 2 * n> values{};
    for (int i = 0; i < 2 * n; ++i) values[i] = std::cos(pi * i / n);
    return values;
  }();
  return table;
}

/// Value and derivative of a Chebyshev series at x in [-1, 1] (Clenshaw).
template <std::size_t n>
std::array<double, 2> evaluate(const std::array<double, n>& c, double x) {
  double b1 = 0, b2 = 0, d1 = 0, d2 = 0;
  for (std::size_t k = n - 1; k > 0; --k) {
    const double d0 = 2 * (b1 + x * d1) - d2;
    const double b0 = c[k] + 2 * x * b1 - b2;
    d2 = d1, d1 = d0, b2 = b1, b1 = b0;
  }
  return {c[0] + x * b1 - b2, b1 + x * d1 - d2};
}

/// Rounding error of the speed between t0 and t1: on a small curve far from the origin, few digits are significant.
double speed_noise(const Nurbs& curve, double t0, double t1) {
  double scale = 0;
  for (const Vec2 pole : curve.poles) scale = std::max({scale, std::abs(pole.x), std::abs(pole.y)});
  const auto above = std::upper_bound(curve.knots.begin(), curve.knots.end() - 1, (t0 + t1) / 2);
  return round_off * scale * curve.degree / (*above - *(above - 1));
}

}  // namespace

ArcLengthTable::ArcLengthTable(const Nurbs& curve, double t0, double t1) {
  double begin = t0;
  const double negligible = 1e-12 * (t1 - t0);
  for (const double knot : curve.knots) {
    if (knot <= begin + negligible || knot >= t1 - negligible) continue;
    add_span(curve, begin, knot, speed_noise(curve, begin, knot), 0);
    begin = knot;
  }
  add_span(curve, begin, t1, speed_noise(curve, begin, t1), 0);
}

void ArcLengthTable::add_span(const Nurbs& curve, double t0, double t1, double noise, int depth) {
  constexpr int n = degree;
  const auto& cosine = cosines<n>();
  const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
  std::array<double, n + 1> speed{};
  for (int j = 0; j <= n; ++j) speed[j] = norm(curve::derivatives(curve, middle + half * cosine[j], j == 0)[1]);
  // Chebyshev coefficients a of the interpolant of the speed.
  std::array<double, n + 3> a{};
  for (int k = 0; k <= n; ++k) {
    double sum = (speed[0] + speed[n] * (k % 2 == 0 ? 1 : -1)) / 2;
    for (int j = 1; j < n; ++j) sum += speed[j] * cosine[(j * k) % (2 * n)];
    a[k] = sum * 2 / n;
  }
  a[0] /= 2;
  a[n] /= 2;
  const double rest = std::abs(a[n]) + std::abs(a[n - 1]);
  if (depth < max_depth && rest > n * round_off * std::abs(a[0]) + noise) {
    add_span(curve, t0, middle, noise, depth + 1);
    add_span(curve, middle, t1, noise, depth + 1);
    return;
  }
  Span span;
  span.t0 = t0;
  span.t1 = t1;
  span.begin = spans_.empty() ? 0 : spans_.back().end;
  for (int k = 1; k <= n + 1; ++k) span.length[k] = half * ((k == 1 ? 2 : 1) * a[k - 1] - a[k + 1]) / (2 * k);
  for (int k = 1; k <= n + 1; ++k) span.length[0] += (k % 2 == 0 ? -1 : 1) * span.length[k];
  span.end = span.begin + evaluate(span.length, 1)[0];
  spans_.push_back(span);
}

double ArcLengthTable::parameter(double fraction) const {
  const double target = fraction * length();
  const auto found = std::find_if(spans_.begin(), spans_.end(), [&](const Span& span) { return target <= span.end; });
  const Span& span = found == spans_.end() ? spans_.back() : *found;
  const double missing = std::clamp(target - span.begin, 0.0, span.end - span.begin);
  double x = 2 * missing / (span.end - span.begin) - 1;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const auto [s, slope] = evaluate(span.length, x);
    const double step = slope > 0 ? (missing - s) / slope : 0;
    x = std::clamp(x + step, -1.0, 1.0);
    if (std::abs(step) < 1e-9) break;
  }
  return x >= 1 ? span.t1 : x <= -1 ? span.t0 : (span.t0 + span.t1) / 2 + x * (span.t1 - span.t0) / 2;
}

}  // namespace quadrille::triangulate
