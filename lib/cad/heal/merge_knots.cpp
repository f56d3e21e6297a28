#include "heal/merge_knots.hpp"

#include <algorithm>
#include <vector>

#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::heal {
namespace {

// Breaks that become one, with their parameter from then on.
struct Cluster {
  double low = 0, high = 0, target = 0;
  MergedKnots merged;
};

std::vector<Cluster> clusters_of(const Nurbs& curve, double most) {
  std::vector<double> breaks{curve.begin()};
  for (const double t : curve::smoothness_breaks(curve)) breaks.push_back(t);
  breaks.push_back(curve.end());
  const curve::ArcLength length(curve);
  std::vector<Cluster> clusters;
  for (size_t i = 0, next = 1; i < breaks.size(); i = next, ++next) {
    while (next < breaks.size() && length.between(breaks[i], breaks[next]) <= most) ++next;
    if (next == i + 1) continue;
    const double low = breaks[i], high = breaks[next - 1];
    const double target = i == 0 ? low : next == breaks.size() ? high : (low + high) / 2;
    clusters.push_back({low, high, target, {curve::point(curve, target), length.between(low, high)}});
  }
  return clusters;
}

// Poles from number `first` on, `count` of them, become one between the first and the last of them.
void unite_poles(Nurbs& curve, size_t first, size_t count) {
  const size_t last = first + count - 1;
  curve.poles[first] = 0.5 * (curve.poles[first] + curve.poles[last]);
  curve.weights[first] = 0.5 * (curve.weights[first] + curve.weights[last]);
  const auto erase = [&](auto& values) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                 values.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  };
  erase(curve.poles), erase(curve.weights);
}

// A knot of multiplicity m > degree inside the curve has m - degree + 1 poles that the curve comes to, from its left,
// nowhere or from its right; the ends of the curve, of multiplicity degree + 1, keep their outermost pole.
void limit_multiplicity(Nurbs& curve, double knot) {
  const auto first = std::lower_bound(curve.knots.begin(), curve.knots.end(), knot);
  const auto last = std::upper_bound(first, curve.knots.end(), knot);
  const bool is_begin = first == curve.knots.begin(), is_end = last == curve.knots.end();
  const std::ptrdiff_t most = curve.degree + (is_begin || is_end ? 1 : 0), excess = (last - first) - most;
  if (excess <= 0) return;
  const size_t before = static_cast<size_t>(first - curve.knots.begin());
  const size_t num_united = static_cast<size_t>(excess) + 1;
  const size_t start = is_begin ? 0 : is_end ? curve.poles.size() - num_united : before - 1;
  const Vec2 outer = is_begin ? curve.poles.front() : curve.poles.back();
  const double weight = is_begin ? curve.weights.front() : curve.weights.back();
  unite_poles(curve, start, num_united);
  if (is_begin || is_end) curve.poles[start] = outer, curve.weights[start] = weight;
  curve.knots.erase(first, first + excess);
}

}  // namespace

std::optional<MergedKnots> merge_knots(Nurbs& curve, double most) {
  const std::vector<Cluster> clusters = clusters_of(curve, most);
  if (clusters.empty()) return std::nullopt;
  if (clusters.front().low == curve.begin() && clusters.front().high == curve.end()) return std::nullopt;
  for (const Cluster& c : clusters) {
    for (double& knot : curve.knots)
      if (c.low <= knot && knot <= c.high) knot = c.target;
    limit_multiplicity(curve, c.target);
  }
  return std::max_element(clusters.begin(), clusters.end(),
                          [](const Cluster& a, const Cluster& b) { return a.merged.length < b.merged.length; })
      ->merged;
}

}  // namespace quadrille::heal
