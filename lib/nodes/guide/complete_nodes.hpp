#pragma once
// The last step, after all nodes are chosen: elements, order of the nodes.

#include <vector>

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Which nodes have no position of their own yet: those into which a cluster was split, unless it is far from the
/// boundary, and those added for a line field. The only node of a cluster is at its centre and has a position. A node
/// added for a corner keeps its position: the least energy would move it into the corner again.
std::vector<bool> nodes_without_position(const CadFace& face, const CriticalPoints& points);

/// Sets the element that contains each node and sorts the nodes by position. Throws ComputeError if a node is not
/// inside the mesh.
void complete_nodes(const field::FieldEvaluator& evaluator, CriticalPoints& points);

}  // namespace quadrille::guide
