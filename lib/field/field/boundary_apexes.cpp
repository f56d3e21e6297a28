#include "field/boundary_apexes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {
namespace {

// Parameters that differ by less than this (relative to the curve's interval) denote the same point of the curve.
constexpr double parameter_tol = 1e-12;
// Nodes nearer than this to a joint or to each other coincide: at a smaller distance the direction from one to the
// other is rounding error.
constexpr double same_position_tol = 1e-8;

double range_of(const Nurbs& curve) { return curve.end() - curve.begin(); }

// The joint at which a boundary node lies; -1 for a node inside its curve.
int joint_of(const CadFace& face, const BoundaryNode& node) {
  if (node.curve < 0 || node.curve >= face.num_curves())
    throw ComputeError(fmt::format("curve {} does not exist: the face has {}", node.curve, face.num_curves()));
  const Nurbs& curve = face.curves[node.curve];
  const double tol = parameter_tol * range_of(curve);
  if (!(node.t >= curve.begin() - tol && node.t <= curve.end() + tol))
    throw ComputeError(fmt::format("a boundary node at parameter {} is not on curve {}", node.t, node.curve));
  const double near = same_position_tol * range_of(curve);
  if (node.t <= curve.begin() + near) return node.curve;
  return node.t >= curve.end() - near ? face.next_in_loop(node.curve) : -1;
}

std::vector<int> joint_valences(const CadFace& face, const PhaseNodes& prescribed) {
  std::vector<CornerValence> corners = prescribed.corners;
  for (const BoundaryNode& node : prescribed.boundary_nodes) {
    if (const int joint = joint_of(face, node); joint >= 0) corners.push_back({joint, node.valence});
  }
  std::vector<int> valences(face.num_curves(), 2);
  std::vector<bool> is_listed(face.num_curves(), false);
  for (const CornerValence& corner : corners) {
    if (corner.joint < 0 || corner.joint >= face.num_curves())
      throw ComputeError(
          fmt::format("corner {} does not exist: the face has {} joints", corner.joint, face.num_curves()));
    if (is_listed[corner.joint])
      throw ComputeError(fmt::format("the corner at joint {} is listed twice", corner.joint));
    is_listed[corner.joint] = true;
    valences[corner.joint] = corner.valence;
  }
  return valences;
}

// The boundary nodes inside curves, sorted by curve, then t.
std::vector<BoundaryNode> inner_nodes(const CadFace& face, const PhaseNodes& prescribed) {
  std::vector<BoundaryNode> inner;
  for (const BoundaryNode& node : prescribed.boundary_nodes) {
    if (joint_of(face, node) < 0) inner.push_back(node);
  }
  std::sort(inner.begin(), inner.end(), [](const BoundaryNode& a, const BoundaryNode& b) {
    return a.curve != b.curve ? a.curve < b.curve : a.t < b.t;
  });
  return inner;
}

// `branch` is the interior angle up to multiples of 2 pi and rounding. The angle is computed from the same tangents as
// the boundary data, so that the data of both sides of an apex agree to round-off.
BoundaryApex make_apex(const CadFace& face, int curve, double t, double branch, int valence) {
  BoundaryApex apex{curve, t, branch, valence};
  const auto [in, out] = tangents_at(face, apex);
  apex.interior_angle = branch + wrap_pi(pi - (angle_of(out) - angle_of(in)) - branch);
  return apex;
}

}  // namespace

void require_valence_sum(const CadFace& face, const PhaseNodes& prescribed) {
  int inside = 0, corners = 0, boundary = 0;
  for (const PhaseNode& node : prescribed.nodes) inside += 4 - node.valence;
  for (const CornerValence& corner : prescribed.corners) corners += 2 - corner.valence;
  for (const BoundaryNode& node : prescribed.boundary_nodes) boundary += 2 - node.valence;
  const int sum = inside + corners + boundary, expected = 4 * face.euler_characteristic();
  if (sum == expected) return;
  throw ComputeError(
      fmt::format("the valences do not add up: sum (4 - V) over {} interior nodes is {}, sum (2 - V) over {} corners "
                  "is {}, over {} boundary nodes {}; together {}, but a face with {} {} needs {}",
                  prescribed.nodes.size(), inside, prescribed.corners.size(), corners, prescribed.boundary_nodes.size(),
                  boundary, sum, face.num_loops() - 1, face.num_loops() == 2 ? "hole" : "holes", expected));
}

BoundaryApexes boundary_apexes(const CadFace& face, const PhaseNodes& prescribed) {
  const std::vector<int> valences = joint_valences(face, prescribed);
  const std::vector<BoundaryNode> inner = inner_nodes(face, prescribed);
  BoundaryApexes result;
  std::vector<BoundaryApex>& apexes = result.apexes;
  auto next = inner.begin();
  for (int c = 0; c < face.num_curves(); ++c) {
    const Nurbs& curve = face.curves[c];
    result.offsets.push_back(static_cast<int>(apexes.size()));
    apexes.push_back(make_apex(face, c, curve.begin(), face.joints[c].interior_angle, valences[c]));
    for (; next != inner.end() && next->curve == c; ++next) {
      if (next->t - apexes.back().t <= same_position_tol * range_of(curve))
        throw ComputeError(fmt::format("two boundary nodes are at the same position on curve {}", c));
      apexes.push_back(make_apex(face, c, next->t, pi, next->valence));
    }
  }
  result.offsets.push_back(static_cast<int>(apexes.size()));
  return result;
}

int find_apex(const CadFace& face, const BoundaryApexes& apexes, int curve, double t) {
  const Nurbs& nurbs = face.curves[curve];
  const double tol = parameter_tol * range_of(nurbs);
  if (t >= nurbs.end() - tol) return apexes.offsets[face.next_in_loop(curve)];
  for (int a = apexes.offsets[curve]; a < apexes.offsets[curve + 1]; ++a) {
    if (std::abs(t - apexes.apexes[a].t) <= tol) return a;
  }
  return -1;
}

ApexTangents tangents_at(const CadFace& face, const BoundaryApex& apex) {
  const Nurbs& curve = face.curves[apex.curve];
  const bool is_joint = apex.t == curve.begin();
  const Nurbs& before = is_joint ? face.curves[face.previous_in_loop(apex.curve)] : curve;
  return {curve::tangent(before, is_joint ? before.end() : apex.t, true), curve::tangent(curve, apex.t)};
}

}  // namespace quadrille::field
