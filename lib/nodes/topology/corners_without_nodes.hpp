#pragma once
// Corner valences with which the index sum needs no irregular node inside, or as few as possible.

#include <vector>

#include "guide/corner_override.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::topology {

/// The corners whose valences change. A corner may have its present valence, or any whose blocks have 40 to 140
/// degrees; one that was prescribed or divided keeps its valence, and corners that symmetries of the face map onto each
/// other have the same. Among these choices:
///   1. the least index that is left for nodes inside, |4 chi - sum (2 - V)|,
///   2. the least angle defect, sum V |omega / (90 V) - 1|^2, omega in degrees,
///   3. changes where the adjacent sides are longest (the sum over the changed corners),
/// each equal within 1e-6; then the corners that come first in the file keep their valences.
std::vector<guide::CornerOverride> corners_without_nodes(const CadFace& face, const CriticalPoints& points);

}  // namespace quadrille::topology
