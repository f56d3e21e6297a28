#pragma once
// The jumps of a discontinuous field (hybridised DG) across the edges of its mesh, on which the count of zeros depends.
//
// Such a field has two values on an edge, and a zero near the edge may appear on both sides or on neither. Zeros are
// therefore those of a continuous field w that stays within the local jump of the one-sided values; any such w will do:
// if J is regular and varies by less than the jump allows, all of them have the same zeros, each within |J^-1 jump| of
// the one-sided one. Hence the search of an element is widened by the jump (zeros/zero_search), and zeros of two
// elements that are nearer than their shifts are merged (zeros/distinct_zeros).

#include <array>
#include <vector>

#include "field/evaluate.hpp"

namespace quadrille::zeros {

/// The jumps of one element.
struct Jumps {
  std::array<double, 3> edge{};    ///< across local edge k, 0 on the boundary
  std::array<double, 3> vertex{};  ///< at local vertex k: the sum over half the edges that meet there
};

/// The jumps of each element. The jump of an edge is twice the greatest at P + 2 points. Empty for continuous fields
/// (method "cg").
std::vector<Jumps> edge_jumps(const field::FieldEvaluator& evaluator);

}  // namespace quadrille::zeros
