#include "guide/line_field.hpp"

#include <fmt/format.h>

#include "curve/symmetry.hpp"
#include "guide/line_corners.hpp"
#include "guide/node_ring.hpp"
#include "placement/interior_point.hpp"

namespace quadrille::guide {
namespace {

NodeChange corner_change(const Corner& corner) {
  const std::string reason =
      fmt::format("the zeros of the field cannot be isolated: valence {} by rule at the corner of {:.6g} degrees",
                  corner.valence, corner.angle_degrees);
  return {ChangeKind::line, reason, {}, {{corner.position, corner.valence, NodeLocation::corner}}};
}

/// The centre of all nodes: a point that is invariant under the symmetries of the face.
Vec2 middle_of(const CadFace& face, const std::vector<curve::Isometry>& group) {
  const bool has_rotations = group.size() > 1 && !group[1].is_mirrored;
  return has_rotations ? group[0].centre : placement::most_interior_point(face, group);
}

NodeChange nodes_change(const std::vector<CriticalPoint>& nodes, int index) {
  NodeChange change{ChangeKind::line,
                    fmt::format("no choice of corner valences that is as symmetric as the face has the right index "
                                "sum: nodes inside have the missing index {}",
                                index),
                    {},
                    {}};
  for (const CriticalPoint& node : nodes) change.after.push_back({node.position, node.valence, NodeLocation::inside});
  return change;
}

}  // namespace

CriticalPoints line_field_points(const CadFace& face, int max_valence) {
  const std::vector<curve::Isometry> group = curve::symmetries(face);
  const LineCorners chosen = line_corners(face, group);
  CriticalPoints points;
  points.form = NodeForm::phase;
  points.origin = face.origin;
  points.corners = chosen.corners;
  for (const Corner& corner : chosen.corners)
    if (corner.source == NodeSource::line) points.changes.push_back(corner_change(corner));
  if (chosen.missing_index != 0) {
    Cluster cluster;
    cluster.centre = middle_of(face, group);
    cluster.index = chosen.missing_index;
    points.critical_points = cluster_nodes(face, group, max_valence, cluster, {}, NodeSource::line);
    points.changes.push_back(nodes_change(points.critical_points, chosen.missing_index));
  }
  points.index_sum = index_sum_of(points);
  points.index_sum_expected = 4 * face.euler_characteristic();
  return points;
}

}  // namespace quadrille::guide
