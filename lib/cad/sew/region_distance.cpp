#include "sew/region_distance.hpp"

#include <algorithm>
#include <limits>

#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::sew {
namespace {

constexpr int samples_per_span = 16;
constexpr int refinements = 20;
/// Samples inside a region lie this part of the curve's size beside it.
constexpr double inward = 1e-2;

struct Sample {
  Vec2 position, normal;  // the normal points into the region
};

std::vector<Sample> samples_of(const Nurbs& curve) {
  std::vector<Sample> samples;
  for (size_t k = 1; k < curve.knots.size(); ++k) {
    const double t0 = curve.knots[k - 1], t1 = curve.knots[k];
    for (int i = 0; i < samples_per_span && t0 < t1; ++i) {
      const double t = t0 + (t1 - t0) * (i + 0.5) / samples_per_span;
      samples.push_back({curve::point(curve, t), left_of(curve::tangent(curve, t))});
    }
  }
  return samples;
}

/// Samples on the boundary of `a` and beside it that are inside of `b`.
void find_overlap(const Region& a, const Region& b, double negligible, std::optional<MeasuredPlace>& deepest) {
  const curve::PoleBox box = region_box(b);
  const auto consider = [&](Vec2 x, bool is_on_boundary) {
    if (!box.contains(x)) return;
    double depth = distance_from_boundary(b, x);
    if (!is_on_boundary) depth = std::min(depth, distance_from_boundary(a, x));
    if (depth <= std::max(negligible, deepest ? deepest->size : 0) || !contains(b, x)) return;
    if (is_on_boundary || contains(a, x)) deepest = {x, depth};
  };
  for (const heal::LoopCurve& c : a.curves) {
    const double beside = inward * curve::pole_box(c.curve).diagonal();
    for (const Sample& sample : samples_of(c.curve)) {
      consider(sample.position, true);
      consider(sample.position + beside * sample.normal, false);
    }
  }
}

}  // namespace

double distance_from_boundary(const Region& region, Vec2 x) {
  double least = std::numeric_limits<double>::infinity();
  for (const heal::LoopCurve& c : region.curves) least = std::min(least, curve::project(c.curve, x).distance);
  return least;
}

bool contains(const Region& region, Vec2 x) {
  int winding = 0;
  for (const auto& loop : loop_curves(region)) winding += outline::winding_number(loop, x);
  return winding > 0;
}

std::optional<MeasuredPlace> overlap(const Region& a, const Region& b, double negligible) {
  std::optional<MeasuredPlace> deepest;
  find_overlap(a, b, negligible, deepest);
  find_overlap(b, a, negligible, deepest);
  return deepest;
}

MeasuredPlace gap_between(const Region& a, const Region& b) {
  const Nurbs *from = nullptr, *to = nullptr;
  Vec2 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [own, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const heal::LoopCurve& c : own->curves) {
      std::vector<Vec2> points{c.curve.poles.front()};
      for (const Sample& sample : samples_of(c.curve)) points.push_back(sample.position);
      for (const Vec2 x : points)
        for (const heal::LoopCurve& d : other->curves) {
          const auto foot = curve::project(d.curve, x);
          if (foot.distance < least) least = foot.distance, nearest = foot.position, from = &d.curve, to = &c.curve;
        }
    }
  // From the nearest samples forth and back between the two curves.
  Vec2 opposite = nearest;
  for (int i = 0; i < refinements; ++i) {
    opposite = curve::project(*to, nearest).position;
    nearest = curve::project(*from, opposite).position;
  }
  return {0.5 * (nearest + opposite), distance(nearest, opposite)};
}

}  // namespace quadrille::sew
