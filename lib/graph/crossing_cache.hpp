#pragma once
// Crossings of curves of which few change from one search to the next.

#include <array>
#include <map>
#include <vector>

#include "graph/crossings.hpp"

namespace quadrille::graph {

/// Curves with one key are one curve, now and later.
using CurveKey = std::array<double, 3>;

class CrossingCache {
 public:
  /// find_crossings(splines, same), searched only where a curve is new. The curves that stay must keep their order.
  const std::vector<Crossing>& find(const std::vector<CurveKey>& keys, const std::vector<Nurbs>& splines, double same,
                                    Vec2 origin);

 private:
  std::map<CurveKey, int> numbers_;
  std::vector<Crossing> crossings_;
};

}  // namespace quadrille::graph
