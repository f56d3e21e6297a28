#pragma once
// Each zero once: those on an edge or vertex are found on every side of it, and a discontinuous field may show one on
// both sides of an edge or on neither (zeros/edge_jumps).

#include <vector>

#include "zeros/zero_search.hpp"

namespace quadrille::zeros {

/// Two zeros of equal index are one when they are nearer to each other than their shifts allow; near each other with
/// J of one sign the field is injective, so that two cannot be. Of each group that one stays which lies inside its own
/// element, and of the lowest such element; where none does (the zero falls into the gap) the first that still lies in
/// the mesh. A zero of an element's polynomial that lies beyond the mesh is none.
/// `zeros` as found by searching the elements in ascending order. Quadratic in their number.
std::vector<FoundZero> distinct_zeros(const field::FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros);

/// The open cells but for those that lie no farther from a zero than rounding may shift it: beside a zero with small J
/// the smallest cells cannot be isolated, and what they hold is that zero.
std::vector<OpenCell> unexplained(const std::vector<OpenCell>& open_cells, const std::vector<FoundZero>& zeros);

}  // namespace quadrille::zeros
