#pragma once
// Irregular nodes that small fillets and holes force, taken out of the way of blocks.

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::features {

/// Small fillets and holes (lib/method.md §5): nodes of valence 5 that features below `size` force go onto the
/// boundary, those of valence 3 at convex walls inward to at least `size`, pairs cancel. size = 0: nothing. What a
/// feature is and what it forces: features/feature_bends. Two nodes on the boundary nearer than size / 2 become one of
/// valence 4. Nodes that were moved keep `elem` and `xi` of where they were. Throws UsageError where size is no length.
void resolve_features(const CadFace& face, double size, CriticalPoints& points);

}  // namespace quadrille::features
