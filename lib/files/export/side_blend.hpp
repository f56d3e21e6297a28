#pragma once
// Distance of elements from the blend of their sides, and of sides from the segment between their ends: where both
// vanish, a format may omit curves.
//
// The part of a transfinite blend between two values of xi and two of eta is the blend of its own sides, so elements
// cut out of a blended block lose nothing.

#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// Largest distance of an inner node from the blend of the element's sides (transfinite_loss.hpp); 0 for order 1. Unit
/// of the file.
double distance_from_side_blend(const QuadMesh& mesh, int elem);

/// Largest distance of the nodes of an edge (at Gauss-Lobatto-Legendre points, ends included) from the straight line
/// between its ends, at constant speed. Unit of the file.
double distance_from_chord(const QuadMesh& mesh, const std::vector<int>& edge_nodes);

}  // namespace quadrille::exports
