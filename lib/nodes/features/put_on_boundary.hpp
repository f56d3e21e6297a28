#pragma once
// Rules "boundary" and "corner": nodes of valence 5 that small reflex bends and holes force are moved onto the
// boundary.

#include "features/feature_owners.hpp"

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

}  // namespace quadrille::features
