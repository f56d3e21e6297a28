#pragma once
// Two nodes of valence 3 on the boundary, closer to each other than half the feature size, become one of valence 4.

#include "features/feature_nodes.hpp"
#include "model/cad_face.hpp"

namespace quadrille::features {

/// As at the tip of a slit, where four blocks meet: the ends of a narrow slot, a nose. The node goes into the middle of
/// the boundary between the two, which must have no corner and be no longer than twice the distance. Nearest first;
/// pairs equally near together, those that share a node not at all; nor nodes of one small hole, which has four.
void merge_on_boundary(const CadFace& face, FeatureNodes& state);

}  // namespace quadrille::features
