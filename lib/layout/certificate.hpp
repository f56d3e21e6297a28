#pragma once
// The certificate of a layout (SeparatrixGraph::certificate): what is counted on the finished graph, and what its
// making has left there.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::layout {

/// Sets the method, counts index sum, faces by corners and T-junctions, and turns the largest turn to that of lines of
/// kind "extended" where these turn more: lines through integer grids follow no field. Counts of merges and collapses
/// stay what they are. All goes into the report as well (certificate.*).
void certify(const field::FieldEvaluator& evaluator, const std::string& method, graph::CandidateLayout& layout,
             Report& report);

/// The largest angle between the lines of kind "extended" and the nearest direction of the field's cross, radians, at
/// equal steps inside their arcs: at most pi / 4.
double deviation_of_extended_lines(const field::FieldEvaluator& evaluator, const graph::CandidateLayout& layout);

}  // namespace quadrille::layout
