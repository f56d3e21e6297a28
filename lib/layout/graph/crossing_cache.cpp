#include "graph/crossing_cache.hpp"

#include <algorithm>
#include <utility>

namespace quadrille::graph {

const std::vector<Crossing>& CrossingCache::find(const std::vector<CurveKey>& keys, const std::vector<Nurbs>& splines,
                                                 double same, CrossingBounds bounds) {
  std::map<CurveKey, int> numbers;
  std::vector<int> new_number(numbers_.size(), -1);
  bounds.sought.clear();
  for (int i = 0; i < static_cast<int>(keys.size()); ++i) {
    numbers[keys[i]] = i;
    const auto known = numbers_.find(keys[i]);
    bounds.sought.push_back(known == numbers_.end());
    if (known != numbers_.end()) new_number[known->second] = i;
  }
  std::vector<Crossing> all = find_crossings(splines, same, bounds);
  for (Crossing c : crossings_) {
    c.a = new_number[c.a], c.b = new_number[c.b];
    if (c.a >= 0 && c.b >= 0) all.push_back(c);
  }
  std::stable_sort(all.begin(), all.end(), comes_before);
  numbers_ = std::move(numbers);
  crossings_ = std::move(all);
  return crossings_;
}

}  // namespace quadrille::graph
