#pragma once
// Lines to the small fillets whose nodes critpoints moved inward (simplify/end_on_fillets.hpp).

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "model/critical_points.hpp"

namespace quadrille::layout {

/// Ends lines of the layout on these fillets where that makes better blocks. The fillets are those of the record of
/// changes: a node of valence 3 that moved because of a feature was beside the middle of its fillet. Raises the largest
/// deviation of the certificate. Reports fillets.lines_moved if there are such fillets. Every face must have four
/// corners.
void end_lines_on_fillets(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                          graph::CandidateLayout& layout, Report& report);

}  // namespace quadrille::layout
