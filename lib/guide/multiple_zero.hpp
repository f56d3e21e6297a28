#pragma once
// Zeros of higher order: what the search for isolated zeros cannot resolve.

#include "guide/zero_search.hpp"

namespace quadrille {

/// Throws ComputeError, with place and index, when cells stayed open or when |v| between two of the zeros stays below
/// `field_noise`, so that they cannot be told from a multiple zero.
void require_simple_zeros(const FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros,
                          const std::vector<OpenCell>& open_cells);

}  // namespace quadrille
