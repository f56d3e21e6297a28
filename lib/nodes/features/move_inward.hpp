#pragma once
// Rule "inward": nodes of valence 3 that small convex bends force move away from the boundary. On a smooth boundary
// they would have no valid block (lib/method.md §5).

#include "features/boundary_clearance.hpp"
#include "features/feature_owners.hpp"

namespace quadrille::features {

/// A node of a convex bend and the straight path along which it moves.
struct InwardMove {
  int node = 0;
  Vec2 start, direction;  ///< unit
  double radius = 0;      ///< of the bend, for the recorded reason
};

/// The path of a node: along the bisector of a bend with index capacity 1, else away from the node's own foot.
InwardMove inward_move(const CadFace& face, const FeatureNode& node, const SmallFeature& feature,
                       const OwnedNode& owned);

/// Each node moves along its path until its clearance (distance to the boundary) is L, or until one of two limits: its
/// clearance stops growing, because the opposite boundary becomes the nearest, or reaches the distance to another node.
/// The position of another moving node is the one at which it has the same clearance. All moves are decided together.
void move_inward(FeatureState& state, const BoundaryClearance& clearance, const std::vector<InwardMove>& moves);

}  // namespace quadrille::features
