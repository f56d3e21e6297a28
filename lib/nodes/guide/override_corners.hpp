#pragma once
// Corner valences prescribed by the user, and the nodes that balance them.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Curves a and b that meet at a corner, in either order, and the prescribed valence. If they meet at two corners (a
/// half disc), the corner at which a ends and b begins, with the face on the left.
struct CornerOverride {
  int curve_a = 0, curve_b = 0;
  int valence = 2;
};

/// Parses "a:b=valence", as in --corner-valence 3:4=2; throws UsageError.
CornerOverride parse_corner_override(const std::string& text);

/// Sets the prescribed valences. If the sum of all changes is 0 (valences exchanged between corners), no interior node
/// changes. Otherwise a change from V to V' requires V' - V more index inside. First, nodes of the opposite index, 1 or
/// -1, are removed if they are nearer than a quarter of the diameter and nearer to this corner than to any other that
/// needs them; nodes equally near are removed together or not at all, and a node equally near to two corners stays. For
/// the rest, nodes of valence 3 or 5 are added at equal angles in the corner's sector (a single one on the bisector),
/// at a quarter of the clearance along their rays. Nodes get the source `corner`; each corner is recorded as a change
/// of that kind, exchanged corners together as one. No elements are set. Throws UsageError if the curves meet at no
/// corner, if the valence is not admissible (guide/valence) or if one corner gets two. `why` is the verb of
/// the recorded reasons.
void override_corners(const CadFace& face, const std::vector<CornerOverride>& overrides, CriticalPoints& points,
                      const std::string& why = "is prescribed");

/// Throws UsageError for overrides that `override_corners` would refuse, from the face alone.
void require_corners(const CadFace& face, const std::vector<CornerOverride>& overrides);

}  // namespace quadrille::guide
