#include "features/feature_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::features {
namespace {

constexpr double touch = 1e-9;  // of the diameter

bool is_reflex_joint(const CadFace& face, int joint) { return face.joints[joint].interior_angle > pi + 1e-6; }

/// At a smooth joint both sides count: a fillet's end is reflex, though the straight side beyond it is not.
bool is_reflex(const CadFace& face, int curve, double t) {
  const Nurbs& c = face.curves[curve];
  const double flat = 1e-6 / face.diameter;
  const auto turns_away = [&](int i, double at, bool from_left) {
    return curve::curvature(face.curves[i], at, from_left) < -flat;
  };
  if (t <= c.begin()) {
    if (face.joints[curve].is_corner) return is_reflex_joint(face, curve);
    const int before = face.previous_in_loop(curve);
    return turns_away(curve, t, false) || turns_away(before, face.curves[before].end(), true);
  }
  if (t >= c.end()) {
    const int next = face.next_in_loop(curve);
    if (face.joints[next].is_corner) return is_reflex_joint(face, next);
    return turns_away(curve, t, true) || turns_away(next, face.curves[next].begin(), false);
  }
  return turns_away(curve, t, false);
}

}  // namespace

Walls::Walls(const CadFace& face) : face_(&face) {
  for (const Nurbs& curve : face.curves) {
    Box box{curve.poles.front(), curve.poles.front()};
    for (const Vec2 pole : curve.poles) {
      box.low = {std::min(box.low.x, pole.x), std::min(box.low.y, pole.y)};
      box.high = {std::max(box.high.x, pole.x), std::max(box.high.y, pole.y)};
    }
    boxes_.push_back(box);
  }
}

double Walls::bound(int curve, Vec2 x) const {
  const Box& box = boxes_[curve];
  return std::hypot(std::max({box.low.x - x.x, x.x - box.high.x, 0.0}),
                    std::max({box.low.y - x.y, x.y - box.high.y, 0.0}));
}

double Walls::distance_to(Vec2 x) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (int c = 0; c < face_->num_curves(); ++c) {
    if (bound(c, x) < nearest) nearest = std::min(nearest, curve::project(face_->curves[c], x).distance);
  }
  return nearest;
}

std::vector<WallFoot> Walls::feet(Vec2 x, double reach) const {
  std::vector<WallFoot> feet;
  for (int c = 0; c < face_->num_curves(); ++c) {
    if (bound(c, x) >= reach) continue;
    const curve::Projection p = curve::project(face_->curves[c], x);
    const bool is_known = std::any_of(feet.begin(), feet.end(), [&](const WallFoot& foot) {
      return distance(foot.position, p.position) <= 1e-6 * face_->diameter;
    });
    if (p.distance < reach && !is_known) feet.push_back({p.position, p.distance, is_reflex(*face_, c, p.t)});
  }
  return feet;
}

bool Walls::sees(Vec2 a, Vec2 b) const {
  const double length = distance(a, b), least = touch * face_->diameter;
  for (double s = 0; s < length;) {
    const double room = distance_to(a + (s / length) * (b - a));
    if (room < least) return false;
    s += room;
  }
  return true;
}

}  // namespace quadrille::features
