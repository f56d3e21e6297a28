#pragma once
// All zeros of the guiding field, once each, with indices; valences of corners; the index sum (method.md §1, §3, §5).

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille {

/// Every element is subdivided in Bernstein form until each cell is proved empty or proved to hold at most one zero,
/// which Newton then finds. Sorted by x, then y (equal within 1e-6 of the diameter counts as equal).
/// Does not judge the index sum: see index_sum.
CriticalPoints find_critical_points(const FieldEvaluator& evaluator, Report& report);

/// Throws ComputeError when index_sum != index_sum_expected, saying by how much and which corners are in doubt.
void require_index_sum(const CriticalPoints& points);

}  // namespace quadrille
