#pragma once
// Chooses the pairs of separatrices that are merged among the candidates.

#include <vector>

#include "trace/merged_curve.hpp"

namespace quadrille::trace {

/// Picks pairs in their order so that no line is in two, and returns their numbers; `is_taken` marks the lines that are
/// in a pair, on entry and on return. Pairs that meet after lengths with a relative difference below 1e-6 are decided
/// together: where two of them compete for one line, neither is picked, so that symmetric shapes stay symmetric. Only
/// pairs with allowed[i] are considered.
std::vector<int> choose_merges(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed,
                               std::vector<bool>& is_taken);

}  // namespace quadrille::trace
