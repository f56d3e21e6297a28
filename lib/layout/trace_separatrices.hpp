#pragma once
// From irregular nodes and corners to the planar graph of separatrices and boundary.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "model/critical_points.hpp"

namespace quadrille::layout {

/// Launches, advances, merges, intersects, builds the graph, takes its census and simplifies it
/// (simplify/simplify.hpp). Every line is followed to its end before any merge is decided: the result does not depend
/// on the sequence of the lines or on a step. A domain between two loops in which nothing launches gets four cuts from
/// the inner loop to the outer one, at equal shares of the inner loop's length from the start of its first curve.
/// Throws ComputeError when a bound is met or a face is not four-sided, with the place.
graph::CandidateLayout trace_separatrices(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                          const LayoutOptions& options, Report& report);

}  // namespace quadrille::layout
