#include "features/move_inward.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "features/feature_constants.hpp"

namespace quadrille::features {
namespace {

constexpr int halvings = 60;

/// The path of one node, parametrised by the clearance, which grows along it.
class InwardPath {
 public:
  InwardPath(const BoundaryClearance& boundary, const InwardMove& move, double goal)
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
  double clearance(double s) const { return boundary_->at(point_at(s)); }
  double length_at(double goal, double a, double b) const {
    for (int i = 0; i < halvings; ++i) {
      const double m = (a + b) / 2;
      (clearance(m) < goal ? a : b) = m;
    }
    return (a + b) / 2;
  }
  /// The length along the path, between a and b, at which the clearance is greatest.
  double length_at_ridge(double a, double b) const {
    for (int i = 0; i < 2 * halvings; ++i) {
      const double c = a + (b - a) / 3, d = b - (b - a) / 3;
      if (clearance(c) < clearance(d))
        a = c;
      else
        b = d;
    }
    return (a + b) / 2;
  }

  const BoundaryClearance* boundary_;
  const InwardMove* move_;
  double first_ = 0, last_ = 0, end_ = 0;
};

/// The least clearance between low and high at which `gap` (distance to another node less the clearance) is 0; `high`
/// if the gap is positive everywhere. Samples, then bisection.
template <class Gap>
double clearance_limit(Gap gap, double low, double high) {
  if (gap(low) <= 0) return low;
  constexpr int steps = feature_constants.path_steps;
  double a = low, b = high;
  for (int i = 1; i <= steps; ++i) {
    const double w = low + (high - low) * i / steps;
    if (gap(w) <= 0) {
      b = w;
      break;
    }
    a = w;
    if (i == steps) return high;
  }
  for (int i = 0; i < halvings; ++i) {
    const double m = (a + b) / 2;
    (gap(m) > 0 ? a : b) = m;
  }
  return a;
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

InwardMove inward_move(const CadFace& face, const FeatureNode& node, const SmallFeature& feature,
                       const OwnedNode& owned) {
  if (feature.index_capacity > 1)
    return {owned.node, node.position, normalized(node.position - owned.foot.position), feature.extent};
  const SectionPoint middle = feature.section.at(0.5);
  const Vec2 inward = left_of(curve::tangent(face.curves[middle.curve], middle.t));
  return {owned.node, middle.position + dot(node.position - middle.position, inward) * inward, inward, feature.extent};
}

void move_inward(FeatureState& state, const BoundaryClearance& clearance, const std::vector<InwardMove>& moves) {
  std::vector<InwardPath> paths;
  for (const InwardMove& move : moves) paths.emplace_back(clearance, move, state.size);
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
                       moves[i].radius, state.size, clearance.at(before.position), clearance.at(node.position)));
  }
}

}  // namespace quadrille::features
