#pragma once
// Curves the boundary elements of a straight-sided mesh. An element with curved edges becomes
//   x(xi) = affine(xi) + sum over curved edges  lambda_a lambda_b q(lambda_b - lambda_a),
// q the polynomial of degree N - 2 that puts the edge's Gauss-Lobatto-Legendre points on the curve. The map is a
// polynomial of degree N, and straight edges stay exactly straight.

#include <array>
#include <vector>

#include "model/tri_mesh.hpp"
#include "triangulate/edge_fit.hpp"

namespace quadrille::triangulate {

/// Computes the geometry nodes of all elements with an edge on a curve that is not straight: sets mesh.curved_elems and
/// mesh.curved_nodes.
void curve_elements(const EdgeFit& fit, TriMesh& mesh);

/// For each element, a proved lower bound of det(d x / d xi) divided by the determinant of its straight triangle.
std::vector<double> jacobian_ratio_bounds(const TriMesh& mesh);

}  // namespace quadrille::triangulate
