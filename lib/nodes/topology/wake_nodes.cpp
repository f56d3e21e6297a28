#include "topology/wake_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "guide/admissible_valence.hpp"
#include "placement/clearance.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::topology {
namespace {

/// The greatest distance of the corner's loop from the corner, as far as points of its curves tell.
double loop_size(const CadFace& face, int joint) {
  constexpr int points = 8;  // of each curve: a loop may be one curve that begins and ends at the corner
  const int l = face.loop_of(joint);
  double size = 0;
  for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c) {
    const double first = face.curves[c].begin(), last = face.curves[c].end();
    for (int k = 0; k < points; ++k)
      size = std::max(size, distance(curve::point(face.curves[c], first + (last - first) * k / points),
                                     face.joints[joint].position));
  }
  return size;
}

NodeMark node_behind(const CadFace& face, const Corner& corner) {
  const Joint& joint = face.joints[corner.joint];
  const Vec2 direction = unit(joint.tangent_out + joint.interior_angle / 2);
  const double start = tolerance::same_point * face.diameter;  // away from the corner itself
  const double clearance = placement::clearance_along(face, joint.position + start * direction, direction);
  const double length = std::min(2 * loop_size(face, corner.joint), clearance / 2);
  return {joint.position + length * direction, 3};
}

std::vector<NodeMark> wake_nodes(const CadFace& face, const CriticalPoints& points) {
  std::vector<NodeMark> nodes;
  for (const Corner& c : points.corners)
    if (face.loop_of(c.joint) > 0 && c.valence == 3 && c.angle_degrees > 2 * guide::greatest_block_angle)
      nodes.push_back(node_behind(face, c));
  return nodes;
}

}  // namespace

bool set_wake_nodes(const CadFace& face, CriticalPoints& points) {
  placement::NodeEdit edit{ChangeKind::corner,
                           "an O-grid has a node of valence 3 in the wake of each sharp corner",
                           {},
                           wake_nodes(face, points)};
  int left = 0;
  for (std::size_t i = 0; i < points.critical_points.size(); ++i) {
    if (points.critical_points[i].source == NodeSource::divide) continue;
    left += points.critical_points[i].index;
    edit.removed.push_back(i);
  }
  if (edit.added.empty() || left != static_cast<int>(edit.added.size())) return false;
  placement::apply({edit}, points);
  return true;
}

}  // namespace quadrille::topology
