#pragma once
// Rule "merge": two nodes of valence 3 on the boundary, nearer to each other than half the feature size, become one of
// valence 4.

#include "features/feature_state.hpp"
#include "model/cad_face.hpp"

namespace quadrille::features {

/// The merged node is like the tip of a slit, where four blocks meet: at the ends of a narrow slot, or at a nose. It
/// lies in the middle of the boundary between the two, which must have no corner and be no longer than twice their
/// distance. Nearest pairs are merged first; pairs of equal distance together, but not those with a node in common. Two
/// nodes of one small hole are not merged, because a hole needs four, nor nodes on fillets that act as corners
/// (features/acts_as_corner).
void merge_on_boundary(const CadFace& face, FeatureState& state);

}  // namespace quadrille::features
