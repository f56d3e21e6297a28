#pragma once
// Rules "boundary" and "corner": nodes of valence 5 that small reflex bends and holes force are moved onto the
// boundary.
//
// Rule "inward": nodes of valence 3 that small convex bends force move away from the boundary. On a smooth boundary
// they would have no valid block (lib/method.md §5).

#include "curve/face_boundary.hpp"
#include "features/small_features.hpp"

namespace quadrille::features {

/// Puts the nodes of a reflex bend or hole onto its run, with valence 3 each. Their positions:
///   a bend with index capacity 1   the middle of the bend
///   else                           the feet of the nodes on the run, or if these are crowded (FeatureConstants:
///                                  nearer than half the bend's radius; on a hole nearer than half as far as evenly
///                                  spread nodes, or nearer than half the feature size if evenly spread ones are
///                                  not) points spread evenly over the feature's section, on a hole with the mean
///                                  offset of the feet
/// A node whose point is a corner of the layout moves into it: the corner of valence V gets V + 1 blocks, unless these
/// are more than 4 or narrower than 15 degrees; then the node stays inside, at its old position. `id`: the feature's
/// number. Returns the nodes that moved into corners: they are still in the state, to be removed.
std::vector<int> put_on_boundary(const CadFace& face, FeatureState& state, const SmallFeature& feature, int id,
                                 std::vector<OwnedNode> owned);

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
void move_inward(FeatureState& state, const curve::FaceBoundary& boundary, const std::vector<InwardMove>& moves);

}  // namespace quadrille::features
