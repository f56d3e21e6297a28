#pragma once
// Zeros of higher order and curves of zeros: what the search for isolated zeros cannot resolve.

#include "guide/zero_search.hpp"

namespace quadrille {

/// Throws ComputeError when the boundary data lie on one line through 0, on both sides of it: all sides are straight,
/// at multiples of 45 degrees of both parities, and the field vanishes along curves (method.md §3).
void require_no_line_field(const CadFace& face);

/// Throws ComputeError, with place and index, when cells stayed open or when |v| between two of the zeros stays below
/// `field_noise`, so that they cannot be told from a multiple zero.
void require_simple_zeros(const FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros,
                          const std::vector<OpenCell>& open_cells);

}  // namespace quadrille
