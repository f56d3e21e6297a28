#include "placement/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"

namespace quadrille::placement {
namespace {

constexpr double relative_same = 1e-12;  // relative to the diameter: distances that differ by less are equal

/// Decided by the side of the boundary at the nearest point; at a joint by its sector.
bool is_inside(const CadFace& face, const BoundaryFoot& foot, Vec2 x) {
  const Nurbs& curve = face.curves[foot.curve];
  const double end_tol = tolerance::round_off * (curve.end() - curve.begin());
  const bool at_begin = foot.t <= curve.begin() + end_tol, at_end = foot.t >= curve.end() - end_tol;
  if (!at_begin && !at_end) return cross(curve::tangent(curve, foot.t), x - foot.position) > 0;
  const Joint& joint = face.joints[at_begin ? foot.curve : face.next_in_loop(foot.curve)];
  return wrap_two_pi(angle_of(x - joint.position) - joint.tangent_out) < joint.interior_angle;
}

/// Adds the intersections of the ray with the curve: sign changes of the side at steps along the curve, then bisection.
void add_hits(const Nurbs& curve, Vec2 x, Vec2 direction, std::vector<double>& hits) {
  constexpr int steps = 32;
  const auto side = [&](double t) { return cross(direction, curve::point(curve, t) - x) > 0; };
  for (std::size_t k = 1; k < curve.knots.size(); ++k) {
    const double t0 = curve.knots[k - 1], t1 = curve.knots[k];
    for (int i = 0; i < steps && t0 < t1; ++i) {
      double a = t0 + (t1 - t0) * i / steps, b = i + 1 == steps ? t1 : t0 + (t1 - t0) * (i + 1) / steps;
      const bool before = side(a);
      if (side(b) == before) continue;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = (a + b) / 2;
        (side(middle) == before ? a : b) = middle;
      }
      const double along = dot(curve::point(curve, (a + b) / 2) - x, direction);
      if (along > 0) hits.push_back(along);
    }
  }
}

}  // namespace

// Curves that may be near come first: their distances exclude most of the others.
std::vector<BoundaryFoot> nearest_feet(const CadFace& face, Vec2 x) {
  std::vector<std::pair<double, int>> order;
  for (int c = 0; c < face.num_curves(); ++c) order.emplace_back(curve::pole_box(face.curves[c]).distance_from(x), c);
  std::make_heap(order.begin(), order.end(), std::greater<>());  // a few of them are looked at
  const double tol = tolerance::tied * face.diameter;
  std::vector<BoundaryFoot> feet;
  double least = INFINITY;
  while (!order.empty() && order.front().first <= least + tol) {
    const int c = order.front().second;
    std::pop_heap(order.begin(), order.end(), std::greater<>());
    order.pop_back();
    const curve::Projection p = curve::project(face.curves[c], x);
    feet.push_back({c, p.t, p.position, p.distance});
    least = std::min(least, p.distance);
  }
  std::erase_if(feet, [&](const BoundaryFoot& foot) { return foot.distance > least + tol; });
  std::sort(feet.begin(), feet.end(), [](const BoundaryFoot& a, const BoundaryFoot& b) { return a.curve < b.curve; });
  return feet;
}

double signed_clearance(const CadFace& face, Vec2 x) {
  const std::vector<BoundaryFoot> feet = nearest_feet(face, x);
  const auto nearest = std::min_element(
      feet.begin(), feet.end(), [](const BoundaryFoot& a, const BoundaryFoot& b) { return a.distance < b.distance; });
  // The two sides of a slit are equally near: the point is inside if it is on the face's side of one of them.
  const double reach = nearest->distance + relative_same * face.diameter;
  const bool inside = std::any_of(feet.begin(), feet.end(), [&](const BoundaryFoot& foot) {
    return foot.distance <= reach && is_inside(face, foot, x);
  });
  return inside ? nearest->distance : -nearest->distance;
}

double clearance_along(const CadFace& face, Vec2 x, Vec2 direction) {
  std::vector<double> hits{0};
  for (const Nurbs& curve : face.curves) add_hits(curve, x, direction, hits);
  std::sort(hits.begin(), hits.end());
  for (std::size_t i = 1; i < hits.size(); ++i)
    if (signed_clearance(face, x + (hits[i - 1] + hits[i]) / 2 * direction) > 0) return hits[i] - hits[i - 1];
  return 0;
}

}  // namespace quadrille::placement
