#include "field/boundary_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "field/explicit_value.hpp"

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

CornerBridges::CornerBridges(const TriMesh& mesh) {
  const CadFace& face = mesh.face;
  if (face.partners.empty()) return;
  edges_.resize(face.num_curves());
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const Nurbs& nurbs = face.curves[edge.curve];
    const int next = face.next_in_loop(edge.curve);
    if (edge.t0 == nurbs.begin() && face.is_slit_joint(edge.curve))
      edges_[edge.curve].push_back({edge.curve, edge.t0, edge.t1});
    if (edge.t1 == nurbs.end() && face.is_slit_joint(next)) edges_[edge.curve].push_back({next, edge.t1, edge.t0});
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
    : face_(&mesh.face), liftings_(std::move(liftings)), bridges_(mesh) {
  if (face_->partners.empty()) return;
  for (int joint = 0; joint < face_->num_curves(); ++joint) {
    const int before = face_->previous_in_loop(joint);
    means_.push_back((lifted_boundary_value(*face_, liftings_, before, face_->curves[before].end()) +
                      lifted_boundary_value(*face_, liftings_, joint, face_->curves[joint].begin())) /
                     2);
  }
}

Vec2 BoundaryValues::operator()(int curve, double t) const {
  const Vec2 value = lifted_boundary_value(*face_, liftings_, curve, t);
  const auto bridge = bridges_.at(curve, t);
  if (!bridge) return value;
  const Nurbs& nurbs = face_->curves[curve];
  const double end = bridge->joint == curve ? nurbs.begin() : nurbs.end();
  // Without a jump the data stay as they are.
  const Vec2 side = lifted_boundary_value(*face_, liftings_, curve, end);
  return value + (1 - bridge->share) * (means_[bridge->joint] - side);
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

}  // namespace quadrille::field
