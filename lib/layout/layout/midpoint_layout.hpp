#pragma once
// The layout that needs no field: every triangle divided into three four-sided blocks.
//
//          c              Nodes are the vertices, the middles of the edges and the centres. A block lies between a
//         / \             vertex, the middles of its two edges, and the centre. An edge on the boundary keeps its
//        /   \            exact curve and is halved by arc length; all other arcs are straight. An edge that bulges
//       m     m           by b in its middle moves the centre by 4/9 b, as the quadratic triangle through the three
//      /  \ /  \          middles does.
//     /    o    \         .
//    /     |     \        .
//   a------m------b       .
//
// A straight triangle of determinant D (twice its area) makes straight blocks whose Jacobian, on [0, 1]^2, has the
// Bernstein coefficients D/4 at the vertex, D/6 at the middles and D/12 at the centre: they need no proof. Blocks
// beside a curved boundary are measured as quads of order 8 (mesh/transfinite.hpp).

#include <array>
#include <string>
#include <vector>

#include "curve/chain.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "mesh/tri_topology.hpp"
#include "model/arc_graph.hpp"

namespace quadrille::layout {

struct DividedTriangles {
  SeparatrixGraph graph;
  std::vector<std::array<std::array<HalfEdge, 4>, 3>> blocks;  ///< the sides of three blocks for each triangle: block k
                                                               ///< from the triangle's vertex k, counter-clockwise
};

/// Nodes of the graph: vertices, then middles of edges, then centres. The certificate is not filled in.
DividedTriangles divide_triangles(const TriMesh& mesh);

/// A lower bound of det J on [0, 1]^2 of the block with these sides, counter-clockwise; an area. `table` must have the
/// curves of `graph`.
double jacobian_bound(const curve::CurveTable& table, const ArcGraph& graph, const std::array<HalfEdge, 4>& sides);

/// The triangles, ascending, with a curved edge and a block that is not proved valid or nearly degenerate: one whose
/// Jacobian may fall below a tenth of D/12.
std::vector<int> doubtful_triangles(const TriMesh& mesh, const DividedTriangles& divided);

/// Triangulates the face of the mesh anew, coarsely: triangles are refined until their blocks are proved valid.
/// If that fails, the triangles of the mesh, which are proved, are divided. Reports midpoint.*. The certificate is not
/// filled in. Throws ComputeError if there is no mesher.
SeparatrixGraph midpoint_graph(const TriMesh& mesh, const CoarseMesher& mesher, Report& report);

/// The triangles of `mesher`. Reports midpoint.*. Throws ComputeError if there are none, or no mesher.
TriMesh coarse_triangles(const CadFace& face, const CoarseMesher& mesher, Report& report);

/// The layout without its certificate. With a mesher, it cannot fail for a mesh that keeps the rules of its format.
graph::CandidateLayout midpoint_layout(const TriMesh& mesh, const CoarseMesher& mesher, Report& report);

/// The reason for a midpoint division of a file that has triangles but no field; empty if it was chosen. Throws
/// UsageError for a layout that needs a field.
std::string reason_without_field(LayoutChoice choice);

/// Sets the certificate. If the reason is not empty, a warning states it.
void certify_midpoint(graph::CandidateLayout& layout, const std::string& reason, Report& report);

}  // namespace quadrille::layout
