#pragma once
// Corners of the faces of a subdivision, which decide whether it is a layout of four-sided blocks.

#include <vector>

#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// The mean of the middles of a face's arcs, file coordinates: a position for messages.
Vec2 middle_of_face(const Subdivision& subdivision, int face);

/// The faces that are no quadrilaterals: their number of sides or of corners is not four.
std::vector<int> faces_without_four_corners(const Subdivision& subdivision);

/// Throws ComputeError unless every face has four corners and the graph has no more parts than regions; the message
/// states how many faces violate this and the position of the first. Returns the number of faces.
int require_four_corners(const Subdivision& subdivision);

/// Whether the curves at a node start in the counter-clockwise order of the topology. Operations of
/// graph/subdivision.hpp do not check this.
bool is_drawn_in_order(const Subdivision& subdivision, int node);

/// Throws ComputeError with a position unless is_drawn_in_order holds at every node: whoever reads the graph from a
/// file has only its curves, and would find other faces.
void require_drawn_in_order(const Subdivision& subdivision);

/// Number of faces for each number of corners, ascending.
std::vector<FaceCount> face_valence_histogram(const Subdivision& subdivision);

}  // namespace quadrille::graph
