#include "guide/line_field.hpp"

#include <fmt/format.h>

#include "curve/symmetry.hpp"
#include "guide/line_corners.hpp"
#include "guide/node_ring.hpp"
#include "placement/interior_point.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::guide {
namespace {

placement::NodeEdit corner_edit(const Corner& corner) {
  return {ChangeKind::line,
          fmt::format("the zeros of the field cannot be isolated: valence {} by rule at the corner of {:.6g} degrees",
                      corner.valence, corner.angle_degrees),
          {{corner.joint, corner.valence}}};
}

/// The centre of all nodes: a point that is invariant under the symmetries of the face.
Vec2 middle_of(const CadFace& face, const std::vector<curve::Isometry>& group) {
  const bool has_rotations = group.size() > 1 && !group[1].is_mirrored;
  return has_rotations ? group[0].centre : placement::most_interior_point(face, group);
}

placement::NodeEdit nodes_edit(const CadFace& face, const std::vector<curve::Isometry>& group, int max_valence,
                               int index) {
  Cluster cluster;
  cluster.centre = middle_of(face, group);
  cluster.index = index;
  return {ChangeKind::line,
          fmt::format("no choice of corner valences that is as symmetric as the face has the right index sum: nodes "
                      "inside have the missing index {}",
                      index),
          {},
          cluster_nodes(face, group, max_valence, cluster, {})};
}

}  // namespace

CriticalPoints line_field_points(const CadFace& face, int max_valence) {
  const std::vector<curve::Isometry> group = curve::symmetries(face);
  const LineCorners chosen = line_corners(face, group);
  CriticalPoints points;
  points.form = NodeForm::phase;
  points.origin = face.origin;
  points.corners = chosen.corners;
  std::vector<placement::NodeEdit> edits;
  for (const Corner& corner : chosen.corners)
    if (corner.source == NodeSource::line) edits.push_back(corner_edit(corner));
  if (chosen.missing_index != 0) edits.push_back(nodes_edit(face, group, max_valence, chosen.missing_index));
  placement::apply(edits, points);
  points.index_sum_expected = 4 * face.euler_characteristic();
  return points;
}

}  // namespace quadrille::guide
