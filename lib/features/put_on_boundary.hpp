#pragma once
// Rules "boundary" and "corner": nodes of valence 5 that small reflex bends and holes force lie on the boundary.

#include "features/feature_owners.hpp"

namespace quadrille::features {

/// Puts the nodes of a reflex bend or hole onto its run, with valence 3 each. Where:
///   a bend with index capacity 1   the middle of the bend
///   else                           the feet of the nodes on the run, or where these are crowded (FeatureConstants:
///                                  nearer than half the bend's radius; on a hole nearer than half as far as evenly
///                                  spread nodes, or nearer than half the feature size where evenly spread ones are
///                                  not) spread evenly over the feature's section, with the mean offset of the feet on
///                                  a hole
/// A node whose point is a corner of the layout goes into it: the corner of valence V gets V + 1 blocks, unless these
/// were more than 4 or narrower than 15 degrees; then the node stays inside, where it is.
/// `id`: the feature's number. Returns the nodes that corners took: they are still in the state, to be removed.
std::vector<int> put_on_boundary(const CadFace& face, FeatureState& state, const SmallFeature& feature, int id,
                                 std::vector<OwnedNode> owned);

}  // namespace quadrille::features
