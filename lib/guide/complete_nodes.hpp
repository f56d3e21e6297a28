#pragma once
// The last step, when all nodes are chosen: elements, order, index sum.

#include <vector>

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Which nodes have no position of their own yet: those into which a cluster was split and those added for a line
/// field. A cluster's only node is at its centre. A node added for a corner stays where the rule puts it: the least
/// energy would draw it into the corner again.
std::vector<bool> nodes_without_position(const CadFace& face, const CriticalPoints& points);

/// Gives every node the element that holds it, sorts the nodes by position, sets the index sum. Throws ComputeError
/// where a node is not inside the mesh.
void complete_nodes(const field::FieldEvaluator& evaluator, CriticalPoints& points);

}  // namespace quadrille::guide
