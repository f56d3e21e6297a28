#pragma once
// Fillets that are corners on the scale of the distance between nodes: a line that passes one has a corner in it.

#include "features/boundary_clearance.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features {

/// Whether the node, on the boundary, lies on a fillet that is a corner at this distance (feature_constants). Not nodes
/// of a small hole, which move with it.
bool is_on_corner_fillet(const CadFace& face, const FeatureNode& node, double distance);

/// Whether the node, inside, is so near to the boundary that it belongs to such a fillet.
bool is_beside_corner_fillet(const BoundaryClearance& clearance, const FeatureNode& node, double distance);

}  // namespace quadrille::features
