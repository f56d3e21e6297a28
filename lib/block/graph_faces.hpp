#pragma once
// The faces of a separatrix graph inside the domain, as cycles of directed arcs with the face on the left.

#include <vector>

#include "model/separatrix_graph.hpp"

namespace quadrille {

/// Directed arcs as in BlockLayout::block2arcs. A face starts with its lowest arc; faces come in the sequence of their
/// first arcs. A face with a hole in it appears as several cycles. Linear but for sorting the arcs of each node.
std::vector<std::vector<int>> graph_faces(const SeparatrixGraph& graph);

}  // namespace quadrille
