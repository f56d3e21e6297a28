#pragma once
// Rules for pairs of irregular nodes that are nearer to each other than a given length. "Cancel": nodes of opposite
// index cancel. "Merge": two nodes of valence 3 on the boundary become one of valence 4.
//
// Fillets that are much smaller than the distance of two nodes act as corners at this distance: a line that passes one
// has a corner in it.

#include "curve/face_boundary.hpp"
#include "features/feature_state.hpp"
#include "model/cad_face.hpp"

namespace quadrille::features {

/// Pairs nearer than `below` with the segment between them inside the face, nearest first; two boundary nodes are not a
/// pair, nor nodes of fillets that act as corners at their distance. Pairs of equal distance
/// (chained, within the tie) are decided together. A set of nodes that these pairs link
///   is removed                              if its indices add up to 0,
///   becomes one inner node, in the middle,  if they add up to 1 or -1, all are inside and the middle is visible,
///   stays unchanged                         otherwise.
/// Repeated until no remaining pair can cancel. Cubic in the number of nodes.
void cancel_pairs(FeatureState& state, const curve::FaceBoundary& boundary, double below);

/// The merged node is like the tip of a slit, where four blocks meet: at the ends of a narrow slot, or at a nose. It
/// lies in the middle of the boundary between the two, which must have no corner and be no longer than twice their
/// distance. Nearest pairs are merged first; pairs of equal distance together, but not those with a node in common. Two
/// nodes of one small hole are not merged, because a hole needs four, nor nodes on fillets that act as corners.
void merge_on_boundary(const CadFace& face, FeatureState& state);

}  // namespace quadrille::features
