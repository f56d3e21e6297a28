#pragma once
// The same element polynomials by other nodes: each format defines its own points, or control points, on an edge.

#include <Eigen/Dense>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// One position for each of mesh.nodes: the node at Gauss-Lobatto-Legendre point (i, j) of an element becomes the new
/// format's node (i, j). `from_gll` [N+1, N+1] maps the nodes of an edge to the new ones; it keeps the ends and is
/// symmetric under reversal of the edge. Vertices keep their position bit for bit; an edge's nodes are computed once
/// and shared.
std::vector<Vec2> renoded(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll);

}  // namespace quadrille::exports
