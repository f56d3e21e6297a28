#pragma once
// Rule "merge": two nodes of valence 3 on the boundary, nearer to each other than half the feature size, become one of
// valence 4.

#include "features/feature_state.hpp"
#include "model/cad_face.hpp"

namespace quadrille::features {

/// As at the tip of a slit, where four blocks meet: the ends of a narrow slot, a nose. The node lies in the middle of
/// the boundary between the two, which must have no corner and be no longer than twice their distance. Nearest pairs
/// first; pairs of equal distance together, but those that share a node not at all. Two nodes of one small hole are not
/// merged: a hole needs four.
void merge_on_boundary(const CadFace& face, FeatureState& state);

}  // namespace quadrille::features
