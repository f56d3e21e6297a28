#pragma once
// The same element polynomials by Bernstein control points, as VTK's Bezier cells define them.

#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// One control point for each of mesh.nodes: the node at Gauss-Lobatto-Legendre point (i, j) of an element becomes
/// control point (i, j). Vertices keep their position bit for bit; an edge's control points are computed once and
/// shared. The change of basis loses about a digit for every three orders.
std::vector<Vec2> bezier_points(const QuadMesh& mesh);

}  // namespace quadrille::exports
