#pragma once
// Every separatrix that starts at a node, and cuts where none does.

#include <vector>

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "trace/launch.hpp"

namespace quadrille::trace {

/// V lines from each irregular node, V - 1 from each corner and boundary node; Launch::node numbers fixed_nodes. Beside
/// a field of kind "phase" the nodes of `points` must be those of the field, in its order (check_nodes_match_field).
/// Throws ComputeError as fixed_nodes and launch_line.
std::vector<Launch> launch_all(const field::FieldEvaluator& evaluator, const CriticalPoints& points);

/// How many lines launch_all launches.
int num_launches(const CriticalPoints& points);

/// Four lines from the inner loop of a domain between two loops, at equal fractions of its length from the start of its
/// first curve.
std::vector<Launch> launch_cuts(const field::FieldEvaluator& evaluator);

}  // namespace quadrille::trace
