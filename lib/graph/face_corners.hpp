#pragma once
// Corners of the faces of a subdivision: what tells a layout of four-sided blocks from anything else.

#include <vector>

#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// The mean of the middles of a face's arcs, file coordinates: a place to look at.
Vec2 middle_of_face(const Subdivision& subdivision, int face);

/// The faces that are no quadrilaterals: not four corners, or a node of two quarter turns on a side.
std::vector<int> faces_without_four_corners(const Subdivision& subdivision);

/// Throws ComputeError unless every face has four corners and the graph is connected; the message names how many have
/// not, and where the first one lies. Returns the number of faces.
int require_four_corners(const Subdivision& subdivision);

/// Whether the curves at a node start in the order that the topology has, counter-clockwise. Operations trust their
/// callers with this (graph/subdivision.hpp).
bool is_drawn_in_order(const Subdivision& subdivision, int node);

/// Number of faces by number of corners, by rising corners.
std::vector<FaceCount> face_valence_histogram(const Subdivision& subdivision);

}  // namespace quadrille::graph
