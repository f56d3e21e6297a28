#include "features/resolve_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "features/feature_state.hpp"
#include "features/move_nodes.hpp"
#include "features/node_pairs.hpp"
#include "features/separate_nodes.hpp"
#include "placement/node_ledger.hpp"

namespace quadrille::features {
namespace {

FeatureState initial_state(const CadFace& face, double size, const CriticalPoints& points) {
  FeatureState state;
  state.size = size;
  state.tie = tolerance::tied * face.diameter;
  state.corners = points.corners;
  for (size_t i = 0; i < points.critical_points.size(); ++i) {
    const CriticalPoint& p = points.critical_points[i];
    state.nodes.push_back({p.position, p.valence, NodeLocation::inside, 0, 0, static_cast<int>(i), {}, {}});
  }
  for (size_t i = 0; i < points.boundary_nodes.size(); ++i) {
    const IrregularBoundaryPoint& b = points.boundary_nodes[i];
    state.nodes.push_back({b.position, b.valence, NodeLocation::boundary, b.curve, b.t, static_cast<int>(i), {}, {}});
  }
  return state;
}

bool lies_on(const SmallFeature& feature, const std::vector<bool>& curves) {
  const std::vector<CurveInterval>& intervals = feature.section.intervals();
  return std::any_of(intervals.begin(), intervals.end(), [&](const CurveInterval& i) { return curves[i.curve]; });
}

/// Applies the rules own, boundary, corner, inward.
void move_nodes_of_features(const CadFace& face, const curve::FaceBoundary& boundary,
                            const std::vector<bool>& keeps_clear, FeatureState& state) {
  const std::vector<SmallFeature> features = small_features(face, state.size);
  const std::vector<std::vector<OwnedNode>> owned = nodes_of_features(face, state, features);
  std::vector<InwardMove> moves;
  std::vector<int> taken_by_corners;
  for (size_t f = 0; f < features.size(); ++f) {
    if (owned[f].empty()) continue;
    if (features[f].kind != FeatureKind::convex) {
      if (lies_on(features[f], keeps_clear)) continue;
      const std::vector<int> taken = put_on_boundary(face, state, features[f], static_cast<int>(f), owned[f]);
      taken_by_corners.insert(taken_by_corners.end(), taken.begin(), taken.end());
      continue;
    }
    for (const OwnedNode& own : owned[f]) moves.push_back(inward_move(face, state.nodes[own.node], features[f], own));
  }
  // Moves refer to nodes by number: those that corners took are removed only afterwards.
  move_inward(state, boundary, moves);
  remove_nodes(state, taken_by_corners);
}

CriticalPoint inner_point(const CriticalPoints& points, const FeatureNode& node) {
  const CriticalPoint& point = points.critical_points[node.origin];
  if (!node.is_changed()) return point;
  return placement::changed_node(point, node.position, node.valence, source_of(*node.changed_by));
}

IrregularBoundaryPoint boundary_point(const CriticalPoints& points, const FeatureNode& node) {
  if (!node.is_changed()) return points.boundary_nodes[node.origin];
  return {node.curve, node.t, node.position, node.valence, source_of(*node.changed_by)};
}

void sort_along_boundary(std::vector<IrregularBoundaryPoint>& boundary) {
  std::stable_sort(boundary.begin(), boundary.end(),
                   [](const auto& a, const auto& b) { return a.curve != b.curve ? a.curve < b.curve : a.t < b.t; });
}

bool are_nodes_changed(const FeatureState& state, const CriticalPoints& points) {
  return state.nodes.size() < points.critical_points.size() + points.boundary_nodes.size() ||
         std::any_of(state.nodes.begin(), state.nodes.end(), [](const FeatureNode& n) { return n.is_changed(); });
}

placement::NodeSet nodes_of(const FeatureState& state, const CriticalPoints& points) {
  placement::NodeSet nodes{{}, state.corners, {}};
  for (const FeatureNode& node : state.nodes) {
    if (node.is_inside())
      nodes.critical_points.push_back(inner_point(points, node));
    else
      nodes.boundary_nodes.push_back(boundary_point(points, node));
  }
  sort_along_boundary(nodes.boundary_nodes);
  return nodes;
}

}  // namespace

void resolve_features(const CadFace& face, double size, const std::vector<bool>& keeps_clear, CriticalPoints& points,
                      Progress* progress) {
  if (!(size >= 0) || std::isinf(size))
    throw UsageError(fmt::format("the feature size is {}, it must be a finite length, 0 or more", size));
  if (size == 0) return;
  const curve::FaceBoundary boundary(face);
  FeatureState state = initial_state(face, size, points);
  const std::array<std::function<void()>, 5> rules{
      [&] { cancel_pairs(state, boundary, feature_constants.first_cancellation * size); },
      [&] { move_nodes_of_features(face, boundary, keeps_clear, state); },
      [&] { cancel_pairs(state, boundary, feature_constants.second_cancellation * size); },
      [&] { merge_on_boundary(face, state); }, [&] { separate_nodes(state, boundary); }};
  const Progress::Part part(progress, "rules", std::ssize(rules));
  for (const auto& apply : rules) {
    apply();
    part.advance();
  }
  if (are_nodes_changed(state, points))
    placement::replace_nodes(nodes_of(state, points), state.changes, points);
  else
    placement::record(state.changes, points);
}

}  // namespace quadrille::features
