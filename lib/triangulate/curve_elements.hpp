#pragma once
// Gives a straight mesh the shape of its curves. An element with curved edges becomes
//   x(xi) = affine(xi) + sum over curved edges  lambda_a lambda_b q(lambda_b - lambda_a),
// q the polynomial of degree N - 2 that puts the edge's Gauss-Lobatto-Legendre points on the curve. The map is a
// polynomial of degree N, and its straight edges stay exactly straight.

#include <array>
#include <vector>

#include "model/tri_mesh.hpp"
#include "triangulate/edge_fit.hpp"

namespace quadrille::triangulate {

/// Geometry nodes of all elements that have an edge on a curve which is not straight: fills curved_elems and
/// curved_nodes from the rest of the mesh.
void curve_elements(const EdgeFit& fit, TriMesh& mesh);

/// A proved lower bound of det(d x / d xi) of each element, divided by the det of its straight triangle.
std::vector<double> jacobian_ratio_bounds(const TriMesh& mesh);

}  // namespace quadrille::triangulate
