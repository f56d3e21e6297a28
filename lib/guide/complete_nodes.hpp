#pragma once
// What is left to do when all nodes are chosen.

#include <vector>

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Which nodes have no place of their own yet: those that a cluster was split into or that were made up for a line
/// field. A cluster's only node stands at its centre. What was made up for a corner stays where the rule puts it: the
/// least energy would draw it into the corner again.
std::vector<bool> nodes_without_place(const CadFace& face, const CriticalPoints& points);

/// Gives every node the element that holds it, sorts the nodes by place, sets the index sum. Throws ComputeError where
/// a node is not inside the mesh.
void complete_nodes(const field::FieldEvaluator& evaluator, CriticalPoints& points);

}  // namespace quadrille::guide
