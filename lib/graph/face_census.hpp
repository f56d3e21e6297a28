#pragma once
// Faces of a graph counted by their corners.

#include <vector>

#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// Number of faces by number of corners, by rising corners.
std::vector<FaceCount> face_census(const SeparatrixGraph& graph);

}  // namespace quadrille::graph
