#include "field/corner_lifting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "field/boundary_values.hpp"

namespace quadrille::field {

namespace {

struct Ray {
  Vec2 start, direction;
  double shortest = 0;  // nearer hits are the start of the ray itself
  double aside = 0;     // a ray that passes a curve by less hits it, as rays do that should run through a corner
};

// Extent of a curve's poles along and across the ray. Weights are positive: the curve lies within their hull.
struct Extent {
  double along_min = INFINITY, along_max = -INFINITY, across_min = INFINITY, across_max = -INFINITY;
};

Extent extent(const Nurbs& curve, const Ray& ray) {
  Extent e;
  for (const Vec2 pole : curve.poles) {
    const double along = dot(ray.direction, pole - ray.start), across = cross(ray.direction, pole - ray.start);
    e.along_min = std::min(e.along_min, along);
    e.along_max = std::max(e.along_max, along);
    e.across_min = std::min(e.across_min, across);
    e.across_max = std::max(e.across_max, across);
  }
  return e;
}

bool misses(const Extent& e, const Ray& ray) { return e.across_min > ray.aside || e.across_max < -ray.aside; }

// The distance at which the ray first meets the hull of a short piece of the curve, if that is less than `nearest`.
double first_hit(const Nurbs& curve, const Ray& ray, double nearest) {
  const Extent e = extent(curve, ray);
  if (misses(e, ray) || e.along_max <= ray.shortest || e.along_min >= nearest) return nearest;
  const double size = std::max(e.along_max - e.along_min, e.across_max - e.across_min);
  if (size <= ray.shortest) return std::max(e.along_min, ray.shortest);
  const double middle = (curve.begin() + curve.end()) / 2;
  if (!(middle > curve.begin() && middle < curve.end())) return std::max(e.along_min, ray.shortest);
  const Nurbs first = curve::trimmed(curve, curve.begin(), middle), second = curve::trimmed(curve, middle, curve.end());
  const bool backwards = extent(second, ray).along_min < extent(first, ray).along_min;
  nearest = first_hit(backwards ? second : first, ray, nearest);
  return first_hit(backwards ? first : second, ray, nearest);
}

}  // namespace

Vec2 half_way(const CadFace& face, Vec2 start, Vec2 direction) {
  const Ray ray{start, direction, 1e-6 * face.diameter, 1e-9 * face.diameter};
  // Curves that may be hit early come first: a near hit excludes the curves beyond it.
  std::vector<std::pair<double, int>> order;
  for (int c = 0; c < face.num_curves(); ++c) {
    const Extent e = extent(face.curves[c], ray);
    if (!misses(e, ray)) order.emplace_back(e.along_min, c);
  }
  std::sort(order.begin(), order.end());
  double reach = 2 * face.diameter;
  for (const auto& [along_min, c] : order) reach = first_hit(face.curves[c], ray, reach);
  return start + (reach / 2) * direction;
}

Vec2 exterior_pole(const CadFace& face, Vec2 apex, Vec2 tangent_out, double interior_angle) {
  const Vec2 turn = unit(interior_angle / 2);
  const Vec2 interior_bisector{tangent_out.x * turn.x - tangent_out.y * turn.y,
                               tangent_out.x * turn.y + tangent_out.y * turn.x};
  return half_way(face, apex, -interior_bisector);
}

Lifting lifting_at(const CadFace& face, int joint, Vec2 incoming, Vec2 outgoing) {
  const double angle = face.joints[joint].interior_angle;
  const Vec2 out = curve::tangent(face.curves[joint], face.curves[joint].begin());
  const Vec2 apex = face.joints[joint].position;
  return {joint, apex, exterior_pole(face, apex, out, angle), (incoming - outgoing) / angle};
}

std::vector<Lifting> corner_liftings(const CadFace& face) {
  std::vector<Lifting> liftings;
  for (int joint = 0; joint < face.num_curves(); ++joint) {
    const int before = face.previous_in_loop(joint);
    const Vec2 v_in = boundary_value(face, before, face.curves[before].end());
    const Vec2 v_out = boundary_value(face, joint, face.curves[joint].begin());
    if (norm(v_in - v_out) > jump_tol && !face.is_slit_joint(joint))
      liftings.push_back(lifting_at(face, joint, v_in, v_out));
  }
  return liftings;
}

}  // namespace quadrille::field
