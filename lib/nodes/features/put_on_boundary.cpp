#include "features/put_on_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "features/feature_constants.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::features {
namespace {

using Points = std::vector<SectionPoint>;

/// As many points as feet (ascending fractions): evenly distributed over an open section, or over a closed one with the
/// mean offset of the feet.
Points evenly_spread(const LoopSection& section, const std::vector<double>& feet) {
  const double n = static_cast<double>(feet.size());
  double offset = section.is_closed() ? 0 : 0.5 / n;
  for (size_t i = 0; section.is_closed() && i < feet.size(); ++i) offset += (feet[i] - static_cast<double>(i) / n) / n;
  Points even;
  for (size_t i = 0; i < feet.size(); ++i) even.push_back(section.at(offset + static_cast<double>(i) / n));
  return even;
}

/// The least distance between consecutive points.
double least_distance(const Points& points, bool is_closed) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = is_closed ? 0 : 1; points.size() > 1 && i < points.size(); ++i)
    least = std::min(least, distance(points[i].position, points[i == 0 ? points.size() - 1 : i - 1].position));
  return least;
}

bool are_crowded(const SmallFeature& feature, const Points& at_feet, const Points& even, double spacing) {
  const bool is_hole = feature.kind == FeatureKind::hole;
  const double here = least_distance(at_feet, is_hole), there = least_distance(even, is_hole);
  if (!is_hole) return here < feature_constants.crowded_on_bend * feature.extent;
  return here < feature_constants.crowded_on_hole * there || (here < spacing && there >= spacing);
}

/// The points for nodes with these feet on the run, as fractions in ascending order.
Points points_on(const SmallFeature& feature, const std::vector<double>& feet, double spacing) {
  if (feature.kind != FeatureKind::hole && feature.index_capacity == 1) return {feature.section.at(0.5)};
  Points at_feet;
  for (const double foot : feet) at_feet.push_back(feature.run.at(foot));
  const Points even = evenly_spread(feature.section, feet);
  return are_crowded(feature, at_feet, even, spacing) ? even : at_feet;
}

std::string reason(const FeatureState& state, const SmallFeature& feature, double distance) {
  const std::string what = feature.kind == FeatureKind::hole
                               ? fmt::format("a hole of diameter {:.4g}", feature.extent)
                               : fmt::format("a reflex fillet of radius {:.4g}", feature.extent);
  return fmt::format("{} is below the feature size {:.4g}: its node of valence 5 moves onto the boundary, by {:.4g}",
                     what, state.size, distance);
}

/// Moves the node into the corner if its new valence is admissible; returns whether it did. Until it is removed it lies
/// at the corner, where it stops no other node.
bool put_into_corner(FeatureState& state, int joint, int node, const std::string& why) {
  const auto corner =
      std::find_if(state.corners.begin(), state.corners.end(), [&](const Corner& c) { return c.joint == joint; });
  if (corner == state.corners.end() || corner->valence >= feature_constants.greatest_corner_valence ||
      corner->angle_degrees < feature_constants.least_block_angle * (corner->valence + 1))
    return false;
  const NodeMark before = placement::mark_of(*corner);
  corner->valence += 1;
  corner->source = NodeSource::feature;
  state.changes.push_back({ChangeKind::feature, why, {mark(state.nodes[node]), before}, {placement::mark_of(*corner)}});
  state.nodes[node].position = corner->position;
  return true;
}

/// Replaces feet on the bend by feet on the run and sorts by them, ascending.
void sort_by_foot_on_run(const FeatureState& state, const SmallFeature& feature, std::vector<OwnedNode>& owned) {
  for (OwnedNode& own : owned) own.foot = feature.run.foot(state.nodes[own.node].position);
  std::stable_sort(owned.begin(), owned.end(),
                   [](const OwnedNode& a, const OwnedNode& b) { return a.foot.fraction < b.foot.fraction; });
}

}  // namespace

std::vector<int> put_on_boundary(const CadFace& face, FeatureState& state, const SmallFeature& feature, int id,
                                 std::vector<OwnedNode> owned) {
  sort_by_foot_on_run(state, feature, owned);
  std::vector<double> feet;
  for (const OwnedNode& own : owned) feet.push_back(own.foot.fraction);
  const Points points = points_on(feature, feet, feature_constants.spacing * state.size);
  std::vector<int> taken;
  for (size_t i = 0; i < owned.size(); ++i) {
    const SectionPoint& at = points[i];
    FeatureNode& node = state.nodes[owned[i].node];
    const std::string why = reason(state, feature, owned[i].foot.distance);
    if (face.joints[at.curve].is_corner && at.t == face.curves[at.curve].begin()) {
      if (put_into_corner(state, at.curve, owned[i].node, why)) taken.push_back(owned[i].node);
      continue;
    }
    const FeatureNode before = node;
    node = {at.position, 3, NodeLocation::boundary, at.curve, at.t, before.origin, {}, ChangeKind::feature};
    if (feature.kind == FeatureKind::hole) node.hole = id;
    record(state, ChangeKind::feature, {before}, {node}, why);
  }
  return taken;
}

}  // namespace quadrille::features
