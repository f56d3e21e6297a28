#include "field/boundary_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "field/explicit_value.hpp"
#include "model/interfaces.hpp"

namespace quadrille::field {
namespace {

// (cos 4 theta, sin 4 theta) of a unit tangent, computed as its fourth complex power: exact along the axes, no angle is
// evaluated.
Vec2 fourth_power(Vec2 d) {
  const Vec2 square{d.x * d.x - d.y * d.y, 2 * d.x * d.y};
  return {square.x * square.x - square.y * square.y, 2 * square.x * square.y};
}

enum class CurvePart { begin, inside, end };

// Parameters within round-off of an end are snapped to it: the direction from the joint to a nearer point is noise.
CurvePart part_of(const Nurbs& curve, double t) {
  const double tol = 1e-12 * (curve.end() - curve.begin());
  if (t <= curve.begin() + tol) return CurvePart::begin;
  return t >= curve.end() - tol ? CurvePart::end : CurvePart::inside;
}

// The direction from the joint at one end of the curve into the curve.
Vec2 direction_from_joint(const Nurbs& curve, CurvePart part) {
  return part == CurvePart::begin ? curve::tangent(curve, curve.begin()) : -curve::tangent(curve, curve.end(), true);
}

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

Vec2 boundary_value(const CadFace& face, int curve, double t) {
  const Nurbs& nurbs = face.curves[curve];
  return fourth_power(curve::tangent(nurbs, t, part_of(nurbs, t) == CurvePart::end));
}

Vec2 liftings_on_boundary(const CadFace& face, const std::vector<Lifting>& liftings, int curve, double t) {
  if (liftings.empty()) return {};
  const Nurbs& nurbs = face.curves[curve];
  const CurvePart part = part_of(nurbs, t);
  const int joint = part == CurvePart::begin ? curve : part == CurvePart::end ? face.next_in_loop(curve) : -1;
  const Vec2 x = curve::point(nurbs, t);
  Vec2 sum;
  for (const Lifting& lifting : liftings) {
    const bool at_apex = lifting.joint == joint;
    sum += lifting.jump *
           (at_apex ? lifting_angle_at_apex(lifting, direction_from_joint(nurbs, part)) : lifting_angle(lifting, x));
  }
  return sum;
}

Vec2 lifted_boundary_value(const CadFace& face, const std::vector<Lifting>& liftings, int curve, double t) {
  return boundary_value(face, curve, t) - liftings_on_boundary(face, liftings, curve, t);
}

CornerBridges::CornerBridges(const TriMesh& mesh) : face_(&mesh.face) {
  const CadFace& face = *face_;
  const std::vector<bool> are_enclosed = enclosed_joints(face);
  if (std::find(are_enclosed.begin(), are_enclosed.end(), true) == are_enclosed.end()) return;
  edges_.resize(face.num_curves());
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const Nurbs& nurbs = face.curves[edge.curve];
    const int next = face.next_in_loop(edge.curve);
    if (edge.t0 == nurbs.begin() && are_enclosed[edge.curve])
      edges_[edge.curve].push_back({edge.curve, edge.t0, edge.t1});
    if (edge.t1 == nurbs.end() && are_enclosed[next]) edges_[edge.curve].push_back({next, edge.t1, edge.t0});
  }
}

std::optional<CornerBridges::Point> CornerBridges::at(int curve, double t) const {
  if (edges_.empty()) return {};
  for (const Edge& edge : edges_[curve]) {
    const double share = (t - edge.t_joint) / (edge.t_end - edge.t_joint);
    if (share < 1) return Point{edge.joint, std::max(share, 0.0)};
  }
  return {};
}

BoundaryValues::BoundaryValues(const TriMesh& mesh, std::vector<Lifting> liftings)
    : face_(&mesh.face), liftings_(std::move(liftings)), bridges_(mesh) {}

Vec2 BoundaryValues::operator()(int curve, double t) const {
  const auto lifted = [this](int c, double s) { return lifted_boundary_value(*face_, liftings_, c, s); };
  return bridges_.bridged(lifted, curve, t);
}

bool is_line_field(const CadFace& face) {
  constexpr int samples = 9;
  const Vec2 first = boundary_value(face, 0, face.curves[0].begin());
  bool opposite = false;
  for (int curve = 0; curve < face.num_curves(); ++curve) {
    const Nurbs& nurbs = face.curves[curve];
    for (int i = 0; i < samples; ++i) {
      const double golden = 0.6180339887498949 * i;  // data at equal fractions of a circle would all lie on one line
      const double f = golden - std::floor(golden);
      const Vec2 value = boundary_value(face, curve, nurbs.begin() + f * (nurbs.end() - nurbs.begin()));
      if (std::abs(cross(first, value)) > tolerance::round_off) return false;
      opposite = opposite || dot(first, value) < 0;
    }
  }
  return opposite;
}

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
  const std::vector<bool> are_enclosed = enclosed_joints(face);
  for (int joint = 0; joint < face.num_curves(); ++joint) {
    const int before = face.previous_in_loop(joint);
    const Vec2 v_in = boundary_value(face, before, face.curves[before].end());
    const Vec2 v_out = boundary_value(face, joint, face.curves[joint].begin());
    if (norm(v_in - v_out) > jump_tol && !are_enclosed[joint]) liftings.push_back(lifting_at(face, joint, v_in, v_out));
  }
  return liftings;
}

}  // namespace quadrille::field
