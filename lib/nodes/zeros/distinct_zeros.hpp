#pragma once
// Removes duplicate zeros: a zero on an edge or vertex is found in every adjacent element, and a discontinuous field
// may have a zero on both sides of an edge or on neither (zeros/edge_jumps).

#include <vector>

#include "zeros/zero_search.hpp"

namespace quadrille::zeros {

/// Two zeros of equal index are duplicates if they are nearer to each other than their shifts allow: near each other
/// and with J of one sign the field is injective, so that two zeros are impossible. Of each group the zero is kept that
/// lies inside its own element, and of the lowest such element; if none does (the zero falls into the gap between
/// elements) the first that still lies in the mesh. A zero of an element's polynomial that lies beyond the mesh is
/// removed. `zeros` in the order of a search of the elements in ascending order. Quadratic in their number.
std::vector<FoundZero> distinct_zeros(const field::FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros);

/// The open cells without those that lie no farther from a zero than rounding may shift it: next to a zero with small J
/// the smallest cells cannot be isolated, and they contain that zero.
std::vector<OpenCell> cells_without_zero(const std::vector<OpenCell>& open_cells, const std::vector<FoundZero>& zeros);

}  // namespace quadrille::zeros
