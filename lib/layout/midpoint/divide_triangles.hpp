#pragma once
// Divides every triangle of a mesh into three four-sided blocks.
//
//          c              Nodes are the vertices, the middles of the edges and the centres. A block lies between a
//         / \             vertex, the middles of its two edges, and the centre. An edge on the boundary keeps its
//        /   \            exact curve and is halved by arc length; all other arcs are straight. An edge that bulges
//       m     m           by b in its middle moves the centre by 4/9 b, as the quadratic triangle through the three
//      /  \ /  \          middles does.
//     /    o    \         .
//    /     |     \        .
//   a------m------b       .

#include <array>

#include "mesh/tri_topology.hpp"
#include "model/arc_graph.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::midpoint {

struct DividedTriangles {
  SeparatrixGraph graph;
  std::vector<std::array<std::array<HalfEdge, 4>, 3>> blocks;  ///< the sides of three blocks for each triangle: block k
                                                               ///< from the triangle's vertex k, counter-clockwise
};

/// Nodes of the graph: vertices, then middles of edges, then centres. The certificate is not filled in.
DividedTriangles divide_triangles(const TriMesh& mesh);

}  // namespace quadrille::midpoint
