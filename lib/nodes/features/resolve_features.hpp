#pragma once
// Moves irregular nodes that small fillets and holes force to positions at which blocks of about the feature size L
// fit.
//
// Objective. However small a fillet or a hole is, the field has nodes at a distance of the order of its radius beside
// it (lib/method.md §5). A user who meshes at sizes far above that radius does not want blocks of that size: afterwards
// nodes are L / 2 apart wherever the clearance allows it, and no node that a feature below L forces remains beside it.
//
// Invariants. The index sum. Inner nodes stay inside the face. A node of valence 3 is never put onto a smooth boundary:
// its block would have a corner of 180 degrees. Symmetric sets stay symmetric: equal distances (within 1e-6 diameters)
// are decided together or not at all, and moves are decided for all nodes at once. Each change is recorded with its
// reason and keeps the index. Nodes to which no rule applies are unchanged, to the last bit.
//
// Decisions, in this order. Each starts from the result of the ones before it.
//
//   rule      applies to                                               decision
//   cancel    nodes of opposite index nearer than L that see each      removed, or one node in their middle
//             other, one of them inside (cancel_pairs)
//   own       inner nodes of index 1 or -1 nearer than L to a small    the nearest feature of their sign owns them, up
//             feature (feature_owners)                                 to its index capacity
//   boundary  nodes of valence 5 of a reflex bend or hole              onto the boundary with valence 3, unless nodes
//             (put_on_boundary)                                        keep a distance from it
//   corner    such nodes whose point is a corner of the layout         the corner takes them: one more block there
//   inward    nodes of valence 3 of a convex bend (move_inward)        away from the boundary, up to the distance L
//   cancel    as above, nearer than L / 2; boundary nodes take part    as above
//   merge     two boundary nodes of valence 3 nearer than L / 2        one of valence 4 between them
//             (merge_on_boundary)
//   separate  inner nodes nearer than L / 2 to another node, and       pushed apart; where the clearance is too small
//             changed ones to the boundary (separate_nodes)            for that it is recorded
//
// Reasons for this order. Opposite pairs first: a pair that cancels needs no feature, and a node put onto the boundary
// could no longer find its partner. Boundary and corner before inward: a node that moves onto the boundary or into a
// corner does not stop nodes that move inward. Cancelling again, because moves bring nodes together that were apart.
// Merging before separating: boundary nodes cannot be pushed. All constants are in features/feature_state.

#include <vector>

#include "base/progress.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::features {

/// Applies the rules above with L = `size`, in the file's unit; 0: no change. The definition of a feature and the index
/// that it forces: features/small_features. `keeps_clear`, one per curve: whether nodes keep a distance from the curve
/// (placement/keep_clearance), so that layers along it run past the feature. Nodes that were moved keep `elem` and `xi`
/// of their old position. Throws UsageError if `size` is negative or not finite.
void resolve_features(const CadFace& face, double size, const std::vector<bool>& keeps_clear, CriticalPoints& points,
                      Progress* progress = nullptr);

}  // namespace quadrille::features
