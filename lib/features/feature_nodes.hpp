#pragma once
// What the steps of resolve_features pass on to each other: the nodes, free of what belongs to the field.

#include <optional>
#include <string>
#include <vector>

#include "model/critical_points.hpp"

namespace quadrille::features {

struct FeatureNode {
  Vec2 position;
  int valence = 4;
  int curve = -1;                        ///< -1: inside, else on the boundary
  double t = 0;                          ///< parameter on the curve
  int source = -1;                       ///< index into critical_points or boundary_nodes that it stands for
  int hole = -1;                         ///< small hole that it was put onto
  std::optional<ChangeKind> changed_by;  ///< the last NodeChange

  bool is_inside() const { return curve < 0; }
  bool is_changed() const { return changed_by.has_value(); }
  int index() const { return (is_inside() ? 4 : 2) - valence; }
};

struct FeatureNodes {
  double size = 0;  ///< L
  double tie = 0;   ///< lengths that differ by less are equal
  std::vector<FeatureNode> nodes;
  std::vector<Corner> corners;
  std::vector<NodeChange> changes;
};

/// Takes nodes of valence 4 inside out of the list: they are none.
void drop_regular(FeatureNodes& state);

NodeMark mark(const FeatureNode& node);

/// Adds a change of the kind `feature` or `cancel`.
void record(FeatureNodes& state, ChangeKind kind, const std::vector<FeatureNode>& before,
            const std::vector<FeatureNode>& after, const std::string& reason);

}  // namespace quadrille::features
