#include "features/boundary_clearance.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::features {
namespace {

bool is_reflex_joint(const CadFace& face, int joint) {
  return face.joints[joint].interior_angle > pi + tolerance::same_angle;
}

bool turns_away(const CadFace& face, int curve, double t, bool from_left) {
  return curve::curvature(face.curves[curve], t, from_left) < -tolerance::tied / face.diameter;
}

/// Whether the boundary is reflex at the start of curve `joint`. At a smooth joint either side suffices: the end of a
/// fillet is reflex, though the straight side beyond it is not.
bool is_reflex_at_joint(const CadFace& face, int joint) {
  if (face.joints[joint].is_corner) return is_reflex_joint(face, joint);
  const int before = face.previous_in_loop(joint);
  return turns_away(face, joint, face.curves[joint].begin(), false) ||
         turns_away(face, before, face.curves[before].end(), true);
}

bool is_reflex(const CadFace& face, int curve, double t) {
  if (t <= face.curves[curve].begin()) return is_reflex_at_joint(face, curve);
  if (t >= face.curves[curve].end()) return is_reflex_at_joint(face, face.next_in_loop(curve));
  return turns_away(face, curve, t, false);
}

}  // namespace

BoundaryClearance::BoundaryClearance(const CadFace& face) : face_(&face), boxes_(curve::pole_boxes(face.curves)) {}

double BoundaryClearance::at(Vec2 x) const {
  std::vector<double> bounds;
  for (int c = 0; c < face_->num_curves(); ++c) bounds.push_back(boxes_[c].distance_from(x));
  // The curve that may be nearest first: its distance excludes most of the others.
  const int first = static_cast<int>(std::min_element(bounds.begin(), bounds.end()) - bounds.begin());
  double nearest = curve::project(face_->curves[first], x).distance;
  for (int c = 0; c < face_->num_curves(); ++c) {
    if (c != first && bounds[c] < nearest) nearest = std::min(nearest, curve::project(face_->curves[c], x).distance);
  }
  return nearest;
}

std::vector<CurveFoot> BoundaryClearance::feet(Vec2 x, double reach) const {
  std::vector<CurveFoot> feet;
  for (int c = 0; c < face_->num_curves(); ++c) {
    if (boxes_[c].distance_from(x) >= reach) continue;
    const curve::Projection p = curve::project(face_->curves[c], x);
    const bool is_known = std::any_of(feet.begin(), feet.end(), [&](const CurveFoot& foot) {
      return distance(foot.position, p.position) <= tolerance::same_point * face_->diameter;
    });
    if (p.distance < reach && !is_known) feet.push_back({p.position, p.distance, is_reflex(*face_, c, p.t)});
  }
  return feet;
}

bool BoundaryClearance::is_segment_inside(Vec2 a, Vec2 b) const {
  const double length = distance(a, b), least = tolerance::round_off * face_->diameter;
  for (double s = 0; s < length;) {
    const double clearance = at(a + (s / length) * (b - a));
    if (clearance < least) return false;
    s += clearance;
  }
  return true;
}

}  // namespace quadrille::features
