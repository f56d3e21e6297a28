#pragma once
// Pairs of nodes by their distance.

#include <algorithm>
#include <vector>

namespace quadrille::features {

/// The pairs of the n items 0, ..., n - 1, sorted by their member `distance`; pairs of equal distance are in the order
/// of i, then j. pair_of(i, j) returns the pair of items i < j, or std::nullopt if they form no pair.
template <typename Pair, typename PairOf>
std::vector<Pair> nearest_first(int n, const PairOf& pair_of) {
  std::vector<Pair> pairs;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      if (const auto pair = pair_of(i, j)) pairs.push_back(*pair);
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  return pairs;
}

}  // namespace quadrille::features
