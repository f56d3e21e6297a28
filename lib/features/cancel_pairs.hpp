#pragma once
// Rule "cancel": irregular nodes of opposite index that are nearer to each other than a length cancel.

#include "features/boundary_clearance.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features {

/// Pairs nearer than `below` with the segment between them inside the face, nearest first; two boundary nodes are no
/// pair. Pairs of equal distance (chained, within the tie) are decided together. What they link
///   is removed                         where its indices add up to 0,
///   becomes one inner node, in the middle  where they add up to 1 or -1 and all are inside with the middle in sight,
///   stays as it is                     otherwise.
/// Repeated until no pair is left that can cancel. Cubic in the number of nodes.
void cancel_pairs(FeatureState& state, const BoundaryClearance& clearance, double below);

}  // namespace quadrille::features
