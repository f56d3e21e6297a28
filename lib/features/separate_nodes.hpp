#pragma once
// Rule "separate": irregular nodes nearer to each other than half the feature size are pushed apart.

#include "features/boundary_clearance.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features {

/// Pushes inner nodes apart that are nearer than half the feature size to another node, both alike, and those that were
/// changed off boundaries that are not reflex. Boundary nodes stay where their feature is. All nodes move at once in
/// each round, so that symmetric sets stay symmetric, and the round with the least shortfall counts. Records each move,
/// and the pairs and nodes for which there is no room.
void separate_nodes(FeatureState& state, const BoundaryClearance& clearance);

}  // namespace quadrille::features
