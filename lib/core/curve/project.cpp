#include "curve/project.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

struct Sample {
  double t, distance2;
};

/// A bound of the distance of x from the curve between knots i - 1 and i, which is in the box of this span's poles.
double least_distance2(const Nurbs& curve, std::size_t i, Vec2 x) {
  Vec2 low = curve.poles[i - 1], high = low;
  for (std::size_t j = i - 1 - curve.degree; j < i - 1; ++j) {
    const Vec2 pole = curve.poles[j];
    low = {std::min(low.x, pole.x), std::min(low.y, pole.y)};
    high = {std::max(high.x, pole.x), std::max(high.y, pole.y)};
  }
  return norm2(Vec2{std::max({low.x - x.x, x.x - high.x, 0.0}), std::max({low.y - x.y, x.y - high.y, 0.0})});
}

/// The ends of all spans, and points between them where these may be nearer than all ends.
std::vector<Sample> sampled(const Nurbs& curve, Vec2 x, double t0, double t1) {
  const auto at = [&](double t) { return Sample{t, norm2(point(curve, t) - x)}; };
  std::vector<Sample> ends{at(t0)};
  std::vector<std::size_t> spans;
  double nearest2 = ends[0].distance2;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const double a = std::max(t0, curve.knots[i - 1]), b = std::min(t1, curve.knots[i]);
    if (!(a < b)) continue;
    ends.push_back(at(b));
    spans.push_back(i);
    nearest2 = std::min(nearest2, ends.back().distance2);
  }
  const int per_span = curve.degree == 1 ? 2 : std::max(8, 3 * curve.degree);
  std::vector<Sample> samples{ends[0]};
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const double a = ends[k].t, b = ends[k + 1].t;
    // A sliver of a span, cut off by t0 or t1, must not fill the few best samples with minima that are only rounding.
    const bool has_points = b - a > 1e-6 * (t1 - t0) && least_distance2(curve, spans[k], x) <= nearest2;
    for (int j = 1; has_points && j < per_span; ++j) samples.push_back(at(a + (b - a) * j / per_span));
    samples.push_back(ends[k + 1]);
  }
  return samples;
}

// Newton's method for (C - x) . C' = 0 in [low, high]; halves the interval where Newton's method makes no progress.
double refined(const Nurbs& curve, Vec2 x, double t, double low, double high) {
  for (int iteration = 0; iteration < 60; ++iteration) {
    const auto d = derivatives(curve, t);
    const Vec2 r = d[0] - x;
    const double f = dot(r, d[1]), slope = norm2(d[1]) + dot(r, d[2]);
    if (f == 0) break;
    (f > 0 ? high : low) = t;
    const bool newton = slope > 0 && iteration % 8 != 7;
    const double next = newton ? std::clamp(t - f / slope, low, high) : (low + high) / 2;
    const double moved = std::abs(next - t);
    t = next;
    if (moved <= 2e-16 * std::max(std::abs(t), curve.end() - curve.begin())) break;
  }
  return t;
}

}  // namespace

Projection project(const Nurbs& curve, Vec2 x, double t0, double t1) {
  const std::vector<Sample> samples = sampled(curve, x, t0, t1);
  std::vector<size_t> minima;
  for (size_t i = 0; i < samples.size(); ++i) {
    const bool below_left = i == 0 || samples[i].distance2 <= samples[i - 1].distance2;
    const bool below_right = i + 1 == samples.size() || samples[i].distance2 <= samples[i + 1].distance2;
    if (below_left && below_right) minima.push_back(i);
  }
  std::stable_sort(minima.begin(), minima.end(),
                   [&](size_t a, size_t b) { return samples[a].distance2 < samples[b].distance2; });
  if (minima.size() > 4) minima.resize(4);

  Projection best{samples[minima[0]].t, {}, std::sqrt(samples[minima[0]].distance2)};
  for (const size_t i : minima) {
    const double low = samples[i == 0 ? 0 : i - 1].t, high = samples[std::min(i + 1, samples.size() - 1)].t;
    const double t = low < high ? refined(curve, x, samples[i].t, low, high) : samples[i].t;
    const double d = distance(point(curve, t), x);
    if (d < best.distance) best = {t, {}, d};
  }
  best.position = point(curve, best.t);
  return best;
}

Projection project(const Nurbs& curve, Vec2 x) { return project(curve, x, curve.begin(), curve.end()); }

}  // namespace quadrille::curve
