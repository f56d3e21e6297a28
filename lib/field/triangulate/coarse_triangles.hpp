#pragma once
// Few triangles, for midpoint division (layout/midpoint_layout.hpp).

#include "triangulate/triangulate.hpp"

namespace quadrille::triangulate {

/// Coarse triangles of a face, also of several regions: no fans at singular corners, and no limit to the distance from
/// the curves, which the blocks follow exactly. Triangles that `doubts` names are refined. Throws ComputeError if there
/// are none.
TriMesh coarse_triangles(const CadFace& face, const Doubts& doubts, Report& report);

}  // namespace quadrille::triangulate
