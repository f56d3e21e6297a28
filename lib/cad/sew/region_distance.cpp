#include "sew/region_distance.hpp"

#include <algorithm>
#include <limits>

#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"

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
  curve::for_each_span(curve, [&](double t0, double t1) {
    for (int i = 0; i < samples_per_span; ++i) {
      const double t = t0 + (t1 - t0) * (i + 0.5) / samples_per_span;
      samples.push_back({curve::point(curve, t), left_of(curve::tangent(curve, t))});
    }
  });
  return samples;
}

/// A region with its boundary.
struct BoundedRegion {
  const Region& region;
  curve::CurveTree boundary;
  curve::PoleBox box;

  explicit BoundedRegion(const Region& r) : region(r), boundary(boundary_of(r)), box(region_box(r)) {}
  bool contains(Vec2 x) const { return boundary.winding_number(x) > 0; }
};

/// Samples on the boundary of `a` and beside it that are inside of `b`.
void find_overlap(const BoundedRegion& a, const BoundedRegion& b, double negligible,
                  std::optional<MeasuredPlace>& deepest) {
  const auto consider = [&](Vec2 x, bool is_on_boundary) {
    if (!b.box.contains(x)) return;
    double depth = b.boundary.nearest(x).distance;
    if (!is_on_boundary) depth = std::min(depth, a.boundary.nearest(x).distance);
    if (depth <= std::max(negligible, deepest ? deepest->size : 0) || !b.contains(x)) return;
    if (is_on_boundary || a.contains(x)) deepest = {x, depth};
  };
  for (const heal::LoopCurve& c : a.region.curves) {
    const double beside = inward * curve::pole_box(c.curve).diagonal();
    for (const Sample& sample : samples_of(c.curve)) {
      consider(sample.position, true);
      consider(sample.position + beside * sample.normal, false);
    }
  }
}

}  // namespace

std::optional<MeasuredPlace> overlap(const Region& a, const Region& b, double negligible) {
  const BoundedRegion first(a), second(b);
  std::optional<MeasuredPlace> deepest;
  find_overlap(first, second, negligible, deepest);
  find_overlap(second, first, negligible, deepest);
  return deepest;
}

MeasuredPlace gap_between(const Region& a, const Region& b) {
  const Nurbs *from = nullptr, *to = nullptr;
  Vec2 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [own, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const curve::CurveTree boundary = boundary_of(*other);
    for (const heal::LoopCurve& c : own->curves) {
      std::vector<Vec2> points{c.curve.poles.front()};
      for (const Sample& sample : samples_of(c.curve)) points.push_back(sample.position);
      for (const Vec2 x : points)
        if (const curve::NearestPoint foot = boundary.nearest(x); foot.distance < least)
          least = foot.distance, nearest = foot.position, from = &other->curves[foot.curve].curve, to = &c.curve;
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
