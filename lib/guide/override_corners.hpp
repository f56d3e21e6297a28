#pragma once
// Corner valences that the user prescribes, and the nodes that balance them.

#include <vector>

#include "guide/corner_override.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Sets the prescribed valences. Where all changes together add up to 0 (valences exchanged between corners), nothing
/// inside changes. Else a change from V to V' needs V' - V more index inside. Nodes of the opposite index, 1 or -1, are
/// removed first, if they are nearer than a quarter of the diameter and nearer to this corner than to any other that
/// needs them; of nodes equally near all or none, and one that is equally near to two corners stays. For what is
/// missing, nodes of valence 3 or 5 are added at equal angles in the corner's sector (one: on the bisector), at a
/// quarter of the clearance along their rays. Nodes get the source `corner`, each corner a change of that kind. No
/// elements are set. Throws UsageError where the curves meet in no corner, the valence is not admissible
/// (guide/admissible_valence) or one corner gets two.
void override_corners(const CadFace& face, const std::vector<CornerOverride>& overrides, CriticalPoints& points);

}  // namespace quadrille::guide
