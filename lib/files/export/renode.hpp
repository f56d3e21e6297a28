#pragma once
// The same element polynomials by other nodes: each format defines its own points, or control points, on an edge.
//
// The same element polynomials by Bernstein control points, as VTK's Bezier cells define them.
//
// The same element polynomials through equispaced nodes, as Gmsh, VTK, CGNS and others define them.
//
// The nodes of HOHQMesh's formats: t_j = -cos(j pi / N), j = 0 .. N, ascending in [-1, 1].

#include <Eigen/Dense>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// One position for each of mesh.nodes: the node at Gauss-Lobatto-Legendre point (i, j) of an element becomes the new
/// format's node (i, j). `from_gll` [N+1, N+1] maps the nodes of an edge to the new ones; it keeps the ends and is
/// symmetric under reversal of the edge. Vertices keep their position bit for bit; an edge's nodes are computed once
/// and shared.
std::vector<Vec2> renoded(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll);

/// One control point for each of mesh.nodes: the node at Gauss-Lobatto-Legendre point (i, j) of an element becomes
/// control point (i, j). Vertices keep their position bit for bit; an edge's control points are computed once and
/// shared. The change of basis loses about a digit for every three orders.
std::vector<Vec2> bezier_points(const QuadMesh& mesh);

/// One position for each of mesh.nodes: the node at Gauss-Lobatto-Legendre point (i, j) of an element moves to the
/// equispaced point (i, j). Vertices keep their position bit for bit; an edge's nodes are evaluated once and shared.
std::vector<Vec2> equispaced_nodes(const QuadMesh& mesh);

/// The order + 1 Chebyshev-Gauss-Lobatto points, exactly antisymmetric about 0.
std::vector<double> chebyshev_lobatto_points(int order);

}  // namespace quadrille::exports
