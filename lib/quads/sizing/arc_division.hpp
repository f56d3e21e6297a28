#pragma once
// The ends of the elements along one arc of a block layout.

#include <vector>

namespace quadrille::sizing {

/// Fractions of the arc's length in its own direction, ascending from 0 to 1: element k lies between ends k and k + 1.
struct ArcDivision {
  std::vector<double> ends{0.0, 1.0};

  int num_intervals() const { return static_cast<int>(ends.size()) - 1; }
  double low(int k) const { return ends[k]; }
  double high(int k) const { return ends[k + 1]; }
  double middle(int k) const { return (ends[k] + ends[k + 1]) / 2; }
};

/// One per arc of a layout; arcs of one chord have the same number of intervals.
using ArcDivisions = std::vector<ArcDivision>;

}  // namespace quadrille::sizing
