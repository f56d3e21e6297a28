#pragma once
// How far elements are from what their sides alone say. Formats without inner nodes give an element the transfinite
// blend of its sides (W. J. Gordon and C. A. Hall 1973):
//
//   x(s, t) = (1-t) x(s, 0) + t x(s, 1) + (1-s) x(0, t) + s x(1, t) - (bilinear map of the corners),   s, t in [0, 1].
//
// The part of a blend between two values of s and two of t is the blend of its own sides, so elements cut out of a
// blended block lose nothing.

#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille {

/// Largest distance of an inner node from the blend of the element's sides; 0 for order 1. Unit of the file.
double distance_from_side_blend(const QuadMesh& mesh, int elem);

/// Largest distance of the nodes of an edge (at Gauss-Lobatto-Legendre points, ends included) from the straight line
/// between its ends, walked at constant speed. Unit of the file.
double distance_from_chord(const QuadMesh& mesh, const std::vector<int>& edge_nodes);

}  // namespace quadrille
