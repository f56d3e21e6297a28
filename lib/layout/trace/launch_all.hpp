#pragma once
// Launches every separatrix, and cuts in an annulus without separatrices.

#include <vector>

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "trace/launch.hpp"

namespace quadrille::trace {

/// V lines from each irregular node, V - 1 from each corner and boundary node; Launch::node is a position in
/// fixed_nodes. For a field of kind "phase" the nodes of `points` must be those of the field, in its order
/// (field/check_nodes_match_field). Throws ComputeError as fixed_nodes and launch_line.
std::vector<Launch> launch_all(const field::FieldEvaluator& evaluator, const CriticalPoints& points);

/// Number of lines that launch_all launches.
int num_launches(const CriticalPoints& points);

/// Four lines from the inner loop of a domain between two loops, at equal fractions of its length from the start of its
/// first curve.
std::vector<Launch> launch_cuts(const field::FieldEvaluator& evaluator);

}  // namespace quadrille::trace
