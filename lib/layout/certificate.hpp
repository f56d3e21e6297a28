#pragma once
// The certificate of a layout (SeparatrixGraph::certificate): what is counted on the finished graph, and what its
// computation has recorded there.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::layout {

/// Sets the method, counts index sum, faces by corners and T-junctions, and raises the largest deviation to that of
/// lines of kind LineKind::extended: lines through integer grids do not follow the field. Counts of merges and
/// collapses stay as they are. The report repeats the certificate (certificate.*).
void certify(const field::FieldEvaluator& evaluator, LayoutMethod method, graph::CandidateLayout& layout,
             Report& report);

/// The largest angle between lines of kind LineKind::extended and the nearest direction of the field's cross, radians,
/// at equal steps inside their arcs: at most pi / 4.
double deviation_of_extended_lines(const field::FieldEvaluator& evaluator, const graph::CandidateLayout& layout);

}  // namespace quadrille::layout
