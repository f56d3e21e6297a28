#pragma once
// Cached crossings of curves, few of which change from one search to the next.

#include <array>
#include <map>
#include <vector>

#include "graph/crossings.hpp"

namespace quadrille::graph {

/// Curves with equal keys are the same curve in all searches.
using CurveKey = std::array<double, 3>;

class CrossingCache {
 public:
  /// find_crossings(splines, same, bounds), searched only for pairs with a new curve; bounds.sought is not used. Curves
  /// that occur again must keep their order.
  const std::vector<Crossing>& find(const std::vector<CurveKey>& keys, const std::vector<Nurbs>& splines, double same,
                                    CrossingBounds bounds);

 private:
  std::map<CurveKey, int> numbers_;
  std::vector<Crossing> crossings_;
};

}  // namespace quadrille::graph
