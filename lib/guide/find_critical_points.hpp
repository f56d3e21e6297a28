#pragma once
// All zeros of the guiding field, once each, with indices; valences of corners; the index sum (method.md §1, §3, §5).

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille {

/// Every element is subdivided in Bernstein form until each cell is proved empty or proved to hold at most one zero,
/// which is then found or shown to lie elsewhere (guide/zero_search). Sorted by x, then y (equal within 1e-6 of the
/// diameter counts as equal). The certificate goes to the report as proof.*.
/// Throws ComputeError where zeros are not simple (guide/multiple_zero) or a corner's valence is open (guide/valence).
/// Error bars are set where the field has elem_error.
/// Does not judge the index sum: see require_index_sum.
CriticalPoints find_critical_points(const FieldEvaluator& evaluator, Report& report);

/// Throws ComputeError when index_sum != index_sum_expected, saying by how much and which corner is nearest a tie.
void require_index_sum(const CriticalPoints& points);

}  // namespace quadrille
