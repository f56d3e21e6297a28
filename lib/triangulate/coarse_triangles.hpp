#pragma once
// Few triangles, for midpoint division (midpoint/midpoint_graph.hpp).

#include "base/report.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::triangulate {

/// Coarse triangles of a face, also of several regions: no fans at singular corners, and no limit to the distance from
/// the curves, which the blocks follow exactly. Triangles are refined until their blocks are proved valid
/// (midpoint/doubtful_triangles.hpp). Throws ComputeError if there are none.
TriMesh coarse_triangles(const CadFace& face, Report& report);

}  // namespace quadrille::triangulate
