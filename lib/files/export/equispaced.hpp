#pragma once
// The same element polynomials through equispaced nodes, as Gmsh, VTK, CGNS and others define them.

#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// One position for each of mesh.nodes: the node at Gauss-Lobatto-Legendre point (i, j) of an element moves to the
/// equispaced point (i, j). Vertices keep their position bit for bit; an edge's nodes are evaluated once and shared.
std::vector<Vec2> equispaced_nodes(const QuadMesh& mesh);

}  // namespace quadrille::exports
