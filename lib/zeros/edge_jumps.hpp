#pragma once
// How far a discontinuous field (hybridised DG) jumps across the edges of its mesh, so that its zeros can be counted.
//
// Such a field has two values on an edge, and a zero near it may appear on both sides or on neither. The rule that
// makes it single-valued: any continuous field w will do that stays within the local jump of the one-sided values;
// where J is regular and turns by less than the jump allows, all such w have the same zeros, each within |J^-1 jump| of
// the one-sided one. Hence the search of an element is widened by the jump (zeros/zero_search), and zeros of two
// elements that are nearer than their shifts are one (zeros/distinct_zeros).

#include <array>
#include <vector>

#include "field/evaluate.hpp"

namespace quadrille::zeros {

/// Of one element.
struct Jumps {
  std::array<double, 3> edge{};    ///< across local edge k, 0 on the boundary
  std::array<double, 3> vertex{};  ///< at local vertex k: the sum over half the edges that meet there
};

/// The jumps of each element. Those of edges are the greatest at P + 2 points, doubled. Empty for continuous fields
/// (method "cg").
std::vector<Jumps> edge_jumps(const field::FieldEvaluator& evaluator);

}  // namespace quadrille::zeros
