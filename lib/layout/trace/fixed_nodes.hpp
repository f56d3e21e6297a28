#pragma once
// The nodes of a graph that do not depend on its lines: irregular nodes, corners and irregular points of the boundary.

#include <vector>

#include "graph/build_graph.hpp"
#include "model/critical_points.hpp"

namespace quadrille::trace {

/// Irregular nodes in the order of `points`, then its corners, then its boundary nodes. Throws ComputeError with the
/// position for nodes that no layout can have: degenerate corners (V = 0), nodes with V <= 2, boundary nodes with V <
/// 3.
std::vector<graph::FixedNode> fixed_nodes(const CadFace& face, const CriticalPoints& points);

std::vector<Vec2> positions(const std::vector<graph::FixedNode>& nodes);

}  // namespace quadrille::trace
