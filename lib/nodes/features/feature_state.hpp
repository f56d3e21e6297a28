#pragma once
// The state that the rules of resolve_features pass on to each other: the nodes without their data in the field.

#include <optional>
#include <string>
#include <vector>

#include "model/critical_points.hpp"

namespace quadrille::features {

struct FeatureNode {
  Vec2 position;
  int valence = 4;
  NodeLocation location = NodeLocation::inside;  ///< inside or on the boundary, never a corner
  int curve = 0;                                 ///< on the boundary: its curve
  double t = 0;                                  ///< and parameter
  int origin = 0;           ///< entry of the input's critical_points or, if it was on the boundary, boundary_nodes
  std::optional<int> hole;  ///< small hole onto whose boundary it was moved
  std::optional<ChangeKind> changed_by;  ///< the last change

  bool is_inside() const { return location == NodeLocation::inside; }
  bool is_changed() const { return changed_by.has_value(); }
  int index() const { return (is_inside() ? 4 : 2) - valence; }
};

struct FeatureState {
  double size = 0;  ///< L, in the file's unit
  double tie = 0;   ///< lengths that differ by no more are equal
  std::vector<FeatureNode> nodes;
  std::vector<Corner> corners;
  std::vector<NodeChange> changes;
};

/// Removes the nodes with these indices into state.nodes, in any order; the others keep their order.
void remove_nodes(FeatureState& state, const std::vector<int>& removed);

/// The record of a node in a NodeChange.
NodeMark mark(const FeatureNode& node);

/// Adds a change of the kind `feature` or `cancel`.
void record(FeatureState& state, ChangeKind kind, const std::vector<FeatureNode>& before,
            const std::vector<FeatureNode>& after, const std::string& reason);

}  // namespace quadrille::features
