#pragma once
// Nodes of valence 3 at convex fillets go inward: on a smooth boundary they have no valid block (lib/method.md §5).

#include <vector>

#include "features/feature_nodes.hpp"
#include "features/feature_walls.hpp"

namespace quadrille::features {

/// A node at a convex bend and the straight way on which it may leave it.
struct InwardMove {
  int node = 0;
  Vec2 start, direction;  ///< unit
  double radius = 0;      ///< of the bend, for the reason
};

/// Each node goes along its way until every wall is `size` away, or as far as there is room: no farther than to where
/// the opposite wall, another node, or another moving node at the same distance from its own walls is as near as the
/// nearest wall. All moves are decided together.
void move_inward(FeatureNodes& state, const Walls& walls, const std::vector<InwardMove>& moves);

}  // namespace quadrille::features
