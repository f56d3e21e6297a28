#pragma once
// The fixed nodes of the graph, and every separatrix that leaves them.

#include <vector>

#include "field/evaluate.hpp"
#include "graph/build_graph.hpp"
#include "model/critical_points.hpp"
#include "trace/launch.hpp"

namespace quadrille::trace {

/// Irregular nodes in the sequence of `points`, then its corners, then its boundary nodes. Throws ComputeError where
/// there is no layout: degenerate corners (V = 0), nodes with V <= 2, boundary nodes with V < 3.
std::vector<graph::FixedNode> fixed_nodes(const CadFace& face, const CriticalPoints& points);

/// V lines from each irregular node, V - 1 from each corner and boundary node; Launch::node counts fixed_nodes. Beside
/// a field of kind "phase" the nodes of `points` are those of the field, in its sequence (require_nodes).
std::vector<Launch> launch_all(const field::FieldEvaluator& evaluator, const CriticalPoints& points);

/// How many lines launch_all launches.
int num_launches(const CriticalPoints& points);

/// Four lines from the inner loop of a domain between two loops.
std::vector<Launch> launch_cuts(const field::FieldEvaluator& evaluator);

}  // namespace quadrille::trace
