#pragma once
// How far an edge, a face or a hexahedron is from what a reader rebuilds from less.
//
// P f is the linear interpolant of f between both ends of a coordinate. Blends are Boolean sums of P over the
// coordinates (Gordon and Hall 1973), so that what they miss of x is (1 - P1) x along an edge, (1 - P1)(1 - P2) x on a
// face and (1 - P1)(1 - P2)(1 - P3) x in a hexahedron: of the straight edge, of the blend of four sides, of the blend
// of six faces. Modified bases without inner coefficients, as in Nektar++, are the same blends.

#include <vector>

#include "model/hex_mesh.hpp"

namespace quadrille::exports {

/// The largest distance between nodes and the blend; the first (order + 1)^d of a tensor of Gauss-Lobatto-Legendre
/// points, d = 1, 2 or 3. Unit of the mesh.
double blend_distance(const HexMesh& mesh, const std::vector<int>& nodes);

/// blend_distance within 1e-10 of the shortest line from corner to corner, or 1e-14 of the diameter: of a straight
/// edge, or of a face that is the blend of its sides.
bool is_blend(const HexMesh& mesh, const std::vector<int>& nodes);

/// The largest blend_distance of all elements: how far nodes move that a reader rebuilds from the faces.
double face_blend_loss(const HexMesh& mesh);

/// The middle of an edge between its ends, at the parameter 0.
Vec3 edge_middle(const HexMesh& mesh, const std::vector<int>& nodes);

/// How far nodes move, on edges and elsewhere, if a reader knows only the corners and the middles of the edges: it
/// makes parabolas of these, and adds what they differ from the straight edges, blended linearly, to the trilinear map
/// of the corners. Throws ComputeError with the position if det J is not positive at a Gauss-Lobatto-Legendre point of
/// such an element; `reader` is the program, for the message.
struct QuadraticEdgeLoss {
  double edges = 0, others = 0;
};
QuadraticEdgeLoss quadratic_edge_loss(const HexMesh& mesh, const char* reader);

}  // namespace quadrille::exports
