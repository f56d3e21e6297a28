#pragma once
// Disjoint sets of the numbers 0, 1, ..., n - 1, for connected components (union-find).

#include <algorithm>
#include <numeric>
#include <vector>

namespace quadrille {

class DisjointSets {
 public:
  /// n sets of one number each.
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The least number in the set of i. Amortised almost constant time.
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(int i, int j) {
    const auto [least, other] = std::minmax({find(i), find(j)});
    parent_[other] = least;
  }
  /// The numbers of each set, ascending; the sets by their least number.
  std::vector<std::vector<int>> sets() {
    std::vector<std::vector<int>> by_least(parent_.size());
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) by_least[find(i)].push_back(i);
    std::erase_if(by_least, [](const std::vector<int>& set) { return set.empty(); });
    return by_least;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace quadrille
