#pragma once
// The graph of blocks that needs no field: every triangle divided into three blocks.

#include "base/report.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::midpoint {

/// Triangulates the face of the mesh anew, coarsely: few triangles, no fans at singular corners, and no limit to the
/// distance from the curves, which the blocks follow exactly. Triangles are refined until their blocks are proved valid
/// (midpoint/doubtful_triangles.hpp). If there is no such set of triangles, those of the mesh, which are proved, are
/// divided. Reports midpoint.*. The certificate is not filled in.
SeparatrixGraph midpoint_graph(const TriMesh& mesh, Report& report);

/// The coarse triangles of a face, also of several regions, whose triangles have the same edges on interfaces. Reports
/// midpoint.*. Throws ComputeError if there are none.
TriMesh coarse_triangles(const CadFace& face, Report& report);

/// Three blocks for each triangle.
SeparatrixGraph divided(const TriMesh& triangles);

}  // namespace quadrille::midpoint
