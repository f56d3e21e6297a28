#pragma once
// Interpolation points of the reference triangle, Gauss-Lobatto-Legendre on each edge (Warburton 2006, warp & blend).
//
// Ranking: the three vertices (-1,-1), (1,-1), (-1,1); then the inner nodes of edges 0, 1, 2, each from local vertex k
// to k+1; then the interior nodes.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille::spectral {

/// (N+1)(N+2)/2 points, N >= 1. Computed once per order; the reference stays valid until the program ends.
const std::vector<Vec2>& tri_nodes(int order);

/// Index into tri_nodes(order) of node j = 0..N of local edge `edge`, counted from vertex edge to vertex edge+1.
int tri_edge_node(int order, int edge, int j);

}  // namespace quadrille::spectral
