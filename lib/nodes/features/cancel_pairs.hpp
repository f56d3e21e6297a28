#pragma once
// Rule "cancel": irregular nodes of opposite index cancel if they are nearer to each other than a given length.

#include "features/boundary_clearance.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features {

/// Pairs nearer than `below` with the segment between them inside the face, nearest first; two boundary nodes are not a
/// pair, nor nodes of fillets that act as corners at their distance (features/acts_as_corner). Pairs of equal distance
/// (chained, within the tie) are decided together. A set of nodes that these pairs link
///   is removed                              if its indices add up to 0,
///   becomes one inner node, in the middle,  if they add up to 1 or -1, all are inside and the middle is visible,
///   stays unchanged                         otherwise.
/// Repeated until no remaining pair can cancel. Cubic in the number of nodes.
void cancel_pairs(const CadFace& face, FeatureState& state, const BoundaryClearance& clearance, double below);

}  // namespace quadrille::features
