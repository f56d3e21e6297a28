#include "features/move_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "curve/nurbs.hpp"
#include "features/feature_state.hpp"
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

/// The path of one node, parametrised by the clearance, which grows along it.
class InwardPath {
 public:
  InwardPath(const curve::FaceBoundary& boundary, const InwardMove& move, double goal)
      : boundary_(&boundary), move_(&move) {
    first_ = clearance(0);
    const double step = goal / feature_constants.path_steps;
    double s = 0, here = first_;
    while (here < goal) {
      const double next = clearance(s + step);
      if (next < here) break;
      s += step;
      here = next;
    }
    end_ = here >= goal ? length_at(goal, s - step, s) : length_at_ridge(std::max(s - step, 0.0), s + step);
    last_ = clearance(end_);
  }

  double first_clearance() const { return first_; }
  double last_clearance() const { return last_; }
  /// The position with this clearance, clamped to the path.
  Vec2 at(double clearance) const {
    if (clearance <= first_) return point_at(0);
    return point_at(clearance >= last_ ? end_ : length_at(clearance, 0, end_));
  }

 private:
  Vec2 point_at(double s) const { return move_->start + s * move_->direction; }
  double clearance(double s) const { return boundary_->nearest(point_at(s)).distance; }
  double length_at(double goal, double a, double b) const {
    return bisect([&](double s) { return clearance(s) - goal; }, a, b);
  }
  /// The length along the path, between a and b, at which the clearance is greatest.
  double length_at_ridge(double a, double b) const {
    for (int i = 0; i < 120; ++i) {
      const double c = a + (b - a) / 3, d = b - (b - a) / 3;
      if (clearance(c) < clearance(d))
        a = c;
      else
        b = d;
    }
    return (a + b) / 2;
  }

  const curve::FaceBoundary* boundary_;
  const InwardMove* move_;
  double first_ = 0, last_ = 0, end_ = 0;
};

/// The least clearance between low and high at which `gap` (distance to another node less the clearance) is 0; `high`
/// if the gap is positive everywhere. Samples, then bisection.
template <class Gap>
double clearance_limit(Gap gap, double low, double high) {
  if (gap(low) <= 0) return low;
  constexpr int steps = feature_constants.path_steps;
  double last = low;
  for (int i = 1; i <= steps; ++i) {
    const double w = low + (high - low) * i / steps;
    if (gap(w) <= 0) return bisect(gap, last, w);
    last = w;
  }
  return high;
}

/// The final clearance of the node of move i.
double final_clearance(const FeatureState& state, const std::vector<InwardMove>& moves,
                       const std::vector<InwardPath>& paths, size_t i) {
  double reach = paths[i].last_clearance();
  for (size_t k = 0; k < state.nodes.size(); ++k) {
    const auto other = std::find_if(moves.begin(), moves.end(),
                                    [&](const InwardMove& move) { return move.node == static_cast<int>(k); });
    if (moves[i].node == static_cast<int>(k)) continue;
    const auto rival_at = [&](double clearance) {
      return other == moves.end() ? state.nodes[k].position : paths[other - moves.begin()].at(clearance);
    };
    if (distance(rival_at(reach), paths[i].at(reach)) > feature_constants.farthest_rival * state.size) continue;
    reach = std::min(reach, clearance_limit([&](double w) { return distance(paths[i].at(w), rival_at(w)) - w; },
                                            paths[i].first_clearance(), reach));
  }
  return reach;
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

InwardMove inward_move(const CadFace& face, const FeatureNode& node, const SmallFeature& feature,
                       const OwnedNode& owned) {
  if (feature.index_capacity > 1)
    return {owned.node, node.position, normalized(node.position - owned.foot.position), feature.extent};
  const SectionPoint middle = feature.section.at(0.5);
  const Vec2 inward = left_of(curve::tangent(face.curves[middle.curve], middle.t));
  return {owned.node, middle.position + dot(node.position - middle.position, inward) * inward, inward, feature.extent};
}

void move_inward(FeatureState& state, const curve::FaceBoundary& boundary, const std::vector<InwardMove>& moves) {
  std::vector<InwardPath> paths;
  for (const InwardMove& move : moves) paths.emplace_back(boundary, move, state.size);
  std::vector<Vec2> ends;
  for (size_t i = 0; i < moves.size(); ++i) ends.push_back(paths[i].at(final_clearance(state, moves, paths, i)));
  for (size_t i = 0; i < moves.size(); ++i) {
    FeatureNode& node = state.nodes[moves[i].node];
    const FeatureNode before = node;
    node.position = ends[i];
    node.changed_by = ChangeKind::feature;
    record(state, ChangeKind::feature, {before}, {node},
           fmt::format("a convex fillet of radius {:.4g} is below the feature size {:.4g}: its node of valence 3 moves "
                       "inward, from {:.4g} to {:.4g} from the boundary",
                       moves[i].radius, state.size, boundary.nearest(before.position).distance,
                       boundary.nearest(node.position).distance));
  }
}

}  // namespace quadrille::features
