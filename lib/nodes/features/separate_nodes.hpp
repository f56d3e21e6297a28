#pragma once
// Rule "separate": irregular nodes nearer to each other than half the feature size are pushed apart.

#include "features/boundary_clearance.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features {

/// Pushes inner nodes away from other nodes nearer than half the feature size (two inner nodes by equal amounts), and
/// inner nodes that were changed away from boundaries that are not reflex. Reflex boundary stops a node that is nearer
/// to it than at first and than half the feature size. Boundary nodes stay at their feature. All nodes move at once in
/// each round, so that symmetric sets stay symmetric, and the result is the round with the least shortfall. Records
/// each move, and the pairs and nodes whose clearance is too small.
void separate_nodes(FeatureState& state, const BoundaryClearance& clearance);

}  // namespace quadrille::features
