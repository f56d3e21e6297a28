#pragma once
// The certificate of a layout (SeparatrixGraph::certificate): counts of the finished graph, and values recorded during
// its computation.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::layout {

/// Sets the method, counts index sum, faces by corners and T-junctions, and raises the largest deviation to the
/// deviation of lines of kind LineKind::extended, which do not follow the field of the region through which they run.
/// Counts of merges and collapses are not changed. The report repeats the certificate (certificate.*).
void certify(const field::FieldsOfRegions& fields, LayoutMethod method, graph::CandidateLayout& layout, Report& report);
/// The same for a layout that was made without a field.
void certify(LayoutMethod method, graph::CandidateLayout& layout, Report& report);

/// The largest angle between lines of kind LineKind::extended and the nearest direction of the field's cross, radians,
/// at equal steps inside their arcs: at most pi / 4.
double deviation_of_extended_lines(const field::FieldsOfRegions& fields, const graph::CandidateLayout& layout);

}  // namespace quadrille::layout
