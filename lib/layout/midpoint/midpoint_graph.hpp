#pragma once
// The graph of blocks that needs no field: every triangle divided into three blocks.

#include <functional>
#include <vector>

#include "base/report.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::midpoint {

/// Makes coarse triangles of a face (triangulate/triangulate.hpp), and refines those that the second function
/// names; in a face of several regions they have the same edges on both sides of interfaces. Throws ComputeError if
/// there are none. A function is handed on, so that who does not divide triangles need not be linked with CGAL.
using CoarseMesher =
    std::function<TriMesh(const CadFace&, const std::function<std::vector<int>(const TriMesh&)>&, Report&)>;

/// Triangulates the face of the mesh anew, coarsely: triangles are refined until their blocks are proved valid
/// (midpoint/doubtful_triangles.hpp). If that fails, the triangles of the mesh, which are proved, are
/// divided. Reports midpoint.*. The certificate is not filled in. Throws ComputeError if there is no mesher.
SeparatrixGraph midpoint_graph(const TriMesh& mesh, const CoarseMesher& mesher, Report& report);

/// The triangles of `mesher`. Reports midpoint.*. Throws ComputeError if there are none, or no mesher.
TriMesh coarse_triangles(const CadFace& face, const CoarseMesher& mesher, Report& report);

/// Three blocks for each triangle.
SeparatrixGraph divided(const TriMesh& triangles);

}  // namespace quadrille::midpoint
