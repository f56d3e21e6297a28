#include "surface/space_extent.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "surface/nurbs_surface.hpp"

namespace quadrille::surface {
namespace {

constexpr int samples_per_span = 16;
constexpr int most_steps = 60;

/// The stationary point of the distance between two parameters, by Newton's method in a bracket.
CurveProjection refined(const SpaceCurve& curve, Vec3 x, double low, double high) {
  double t = (low + high) / 2;
  for (int step = 0; step < most_steps && low < high; ++step) {
    const auto d = derivatives(curve, t);
    const Vec3 r = d[0] - x;
    const double f = dot(r, d[1]), slope = norm2(d[1]) + dot(r, d[2]);
    if (f == 0) break;
    (f > 0 ? high : low) = t;
    const double newton = t - f / slope, next = slope > 0 && low < newton && newton < high ? newton : (low + high) / 2;
    if (std::abs(next - t) <= 1e-15 * (curve.end() - curve.begin())) break;
    t = next;
  }
  const Vec3 position = point(curve, t);
  return {t, position, distance(position, x)};
}

}  // namespace

CurveProjection project(const SpaceCurve& curve, Vec3 x) {
  std::vector<double> parameters{curve.begin()}, distances;
  for (std::size_t k = 1; k < curve.knots.size(); ++k)
    for (int j = 1; j <= samples_per_span && curve.knots[k - 1] < curve.knots[k]; ++j)
      parameters.push_back(curve.knots[k - 1] + (curve.knots[k] - curve.knots[k - 1]) * j / samples_per_span);
  for (const double t : parameters) distances.push_back(distance(point(curve, t), x));
  CurveProjection best;
  best.distance = HUGE_VAL;
  const std::size_t last = parameters.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, last);
    if (distances[i] > distances[before] || distances[i] > distances[after]) continue;
    if (distances[i] < best.distance) best = {parameters[i], point(curve, parameters[i]), distances[i]};
    const CurveProjection foot = refined(curve, x, parameters[before], parameters[after]);
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

double diameter(const Chart& chart) {
  const std::vector<Vec3>& nodes = chart.space_nodes;
  Vec3 mean;
  for (const Vec3 node : nodes) mean += node / static_cast<double>(nodes.size());
  const auto farthest_from = [&](Vec3 x) {
    return *std::max_element(nodes.begin(), nodes.end(), [&](Vec3 a, Vec3 b) { return norm2(a - x) < norm2(b - x); });
  };
  double best = 0;
  Vec3 from = farthest_from(mean);
  for (;;) {
    const Vec3 to = farthest_from(from);
    if (!(distance(from, to) > best)) return best;
    best = distance(from, to), from = to;
  }
}

}  // namespace quadrille::surface
