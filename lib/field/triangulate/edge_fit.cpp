#include "triangulate/edge_fit.hpp"

#include <algorithm>
#include <cmath>

#include "curve/nurbs.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::triangulate {
namespace {

constexpr int num_turn_samples = 8;

}  // namespace

EdgeFit::EdgeFit(const Outline& outline, int order) : outline_(&outline), order_(order) {
  const auto& points = spectral::gll_points(order);
  std::vector<double> samples;
  for (int i = 0; i < order; ++i) samples.push_back((points[i] + points[i + 1]) / 2);
  samples_ = spectral::interpolation_matrix(points, samples);
  for (const double x : points) fractions_.push_back((1 + x) / 2);
  for (const double x : samples) sample_fractions_.push_back((1 + x) / 2);
}

std::vector<Vec2> EdgeFit::inner_nodes(int curve, double t0, double t1) const {
  const Nurbs& nurbs = outline_->face().curves[curve];
  return inner_nodes(nurbs, ArcLengthTable(nurbs, t0, t1));
}

std::vector<Vec2> EdgeFit::inner_nodes(const Nurbs& curve, const ArcLengthTable& stretch) const {
  std::vector<Vec2> nodes;
  for (int j = 1; j < order_; ++j) nodes.push_back(curve::point(curve, stretch.parameter(fractions_[j])));
  return nodes;
}

double EdgeFit::error(int curve, double t0, double t1) const {
  const Nurbs& nurbs = outline_->face().curves[curve];
  const ArcLengthTable stretch(nurbs, t0, t1);
  std::vector<Vec2> nodes = inner_nodes(nurbs, stretch);
  nodes.insert(nodes.begin(), curve::point(nurbs, t0));
  nodes.push_back(curve::point(nurbs, t1));
  double worst = 0;
  for (int i = 0; i < order_; ++i) {
    // Coordinates relative to the first node: an error of 1e-12 must exceed the rounding errors of the position.
    Vec2 value;
    for (int j = 1; j <= order_; ++j) value += samples_(i, j) * (nodes[j] - nodes[0]);
    const auto d = curve::derivatives(nurbs, stretch.parameter(sample_fractions_[i]));
    const double speed = norm(d[1]);
    const Vec2 miss = value - (d[0] - nodes[0]);
    worst = std::max(worst, speed > 0 ? std::abs(cross(d[1] / speed, miss)) : norm(miss));
  }
  return worst;
}

double EdgeFit::turn(int curve, double t0, double t1) const {
  const Nurbs& nurbs = outline_->face().curves[curve];
  double sum = 0;
  Vec2 before = curve::tangent(nurbs, t0, false);
  // Each knot span is sampled separately.
  std::vector<double> ends{t0};
  for (const double knot : nurbs.knots)
    if (knot > ends.back() && knot < t1) ends.push_back(knot);
  ends.push_back(t1);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    for (int k = 1; k <= num_turn_samples; ++k) {
      const double t = ends[i] + (ends[i + 1] - ends[i]) * k / num_turn_samples;
      const Vec2 here = curve::tangent(nurbs, t, k == num_turn_samples);
      sum += std::abs(std::atan2(cross(before, here), dot(before, here)));
      before = here;
    }
  }
  return sum;
}

}  // namespace quadrille::triangulate
