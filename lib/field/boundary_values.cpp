#include "field/boundary_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/nurbs.hpp"
#include "field/lifting.hpp"

namespace quadrille::field {

namespace {

// (cos 4 theta, sin 4 theta) of a unit tangent, computed as its fourth complex power: exact along the axes, no angle is
// evaluated.
Vec2 fourth_power(Vec2 d) {
  const Vec2 square{d.x * d.x - d.y * d.y, 2 * d.x * d.y};
  return {square.x * square.x - square.y * square.y, 2 * square.x * square.y};
}

/// Smaller jumps need no bridge (see corner_lifting.cpp).
constexpr double bridged_jump = 1e-10;

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

BoundaryValues::BoundaryValues(const TriMesh& mesh, std::vector<Lifting> liftings)
    : face_(&mesh.face), liftings_(std::move(liftings)) {
  if (face_->partners.empty()) return;
  bridges_.resize(face_->num_curves());
  std::vector<Vec2> means(face_->num_curves());  // at joints
  std::vector<char> has_jump(face_->num_curves(), 0);
  for (int joint = 0; joint < face_->num_curves(); ++joint) {
    const int before = face_->previous_in_loop(joint);
    const Vec2 in = lifted_boundary_value(*face_, liftings_, before, face_->curves[before].end());
    const Vec2 out = lifted_boundary_value(*face_, liftings_, joint, face_->curves[joint].begin());
    means[joint] = (in + out) / 2;
    has_jump[joint] = face_->is_slit_joint(joint) && norm(in - out) > bridged_jump;
  }
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const Nurbs& nurbs = face_->curves[edge.curve];
    const int next = face_->next_in_loop(edge.curve);
    if (has_jump[edge.curve] && edge.t0 == nurbs.begin())
      bridges_[edge.curve].push_back({edge.t0, edge.t1, means[edge.curve]});
    if (has_jump[next] && edge.t1 == nurbs.end()) bridges_[edge.curve].push_back({edge.t1, edge.t0, means[next]});
  }
}

Vec2 BoundaryValues::operator()(int curve, double t) const {
  const Vec2 value = lifted_boundary_value(*face_, liftings_, curve, t);
  if (bridges_.empty()) return value;
  for (const Bridge& bridge : bridges_[curve]) {
    const double share = (t - bridge.t_corner) / (bridge.t_edge - bridge.t_corner);
    if (share < 1) return bridge.mean + std::max(share, 0.0) * (value - bridge.mean);
  }
  return value;
}

bool is_line_field(const CadFace& face) {
  constexpr double tol = 1e-9;
  constexpr int samples = 9;
  const Vec2 first = boundary_value(face, 0, face.curves[0].begin());
  bool opposite = false;
  for (int curve = 0; curve < face.num_curves(); ++curve) {
    const Nurbs& nurbs = face.curves[curve];
    for (int i = 0; i < samples; ++i) {
      const double golden = 0.6180339887498949 * i;  // data at equal fractions of a circle would all lie on one line
      const double f = golden - std::floor(golden);
      const Vec2 value = boundary_value(face, curve, nurbs.begin() + f * (nurbs.end() - nurbs.begin()));
      if (std::abs(cross(first, value)) > tol) return false;
      opposite = opposite || dot(first, value) < 0;
    }
  }
  return opposite;
}

}  // namespace quadrille::field
