#include "topology/wake_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "guide/admissible_valence.hpp"
#include "guide/node_ring.hpp"
#include "placement/clearance.hpp"

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

CriticalPoint node_behind(const CadFace& face, const Corner& corner) {
  const Joint& joint = face.joints[corner.joint];
  const Vec2 direction = unit(joint.tangent_out + joint.interior_angle / 2);
  const double start = 1e-6 * face.diameter;  // away from the corner itself
  const double clearance = placement::clearance_along(face, joint.position + start * direction, direction);
  const double length = std::min(2 * loop_size(face, corner.joint), clearance / 2);
  return guide::made_node(joint.position + length * direction, 1, NodeSource::corner);
}

std::vector<CriticalPoint> wake_nodes(const CadFace& face, const CriticalPoints& points) {
  std::vector<CriticalPoint> nodes;
  for (const Corner& c : points.corners)
    if (face.loop_of(c.joint) > 0 && c.valence == 3 && c.angle_degrees > 2 * guide::greatest_block_angle)
      nodes.push_back(node_behind(face, c));
  return nodes;
}

}  // namespace

bool set_wake_nodes(const CadFace& face, CriticalPoints& points) {
  std::vector<CriticalPoint> nodes = wake_nodes(face, points);
  NodeChange change{ChangeKind::corner, "an O-grid has a node of valence 3 in the wake of each sharp corner", {}, {}};
  std::vector<CriticalPoint> kept;
  int left = 0;
  for (const CriticalPoint& p : points.critical_points) {
    if (p.source == NodeSource::divide) {
      kept.push_back(p);
      continue;
    }
    left += p.index;
    change.before.push_back({p.position, p.valence, NodeLocation::inside});
  }
  if (nodes.empty() || left != static_cast<int>(nodes.size())) return false;
  for (const CriticalPoint& node : nodes) change.after.push_back({node.position, node.valence, NodeLocation::inside});
  kept.insert(kept.end(), nodes.begin(), nodes.end());
  points.critical_points = kept;
  points.changes.push_back(change);
  points.form = NodeForm::phase;
  points.index_sum = index_sum_of(points);
  return true;
}

}  // namespace quadrille::topology
