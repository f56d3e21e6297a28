#pragma once
// The input of the limit on the growth of intervals.

#include <array>
#include <vector>

#include "sizing/arc_division.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::growth {

struct GrowthInput {
  const sizing::MeasuredLayout& measured;
  double limit = 1.3;                           ///< greatest ratio of adjacent intervals that is aimed at, > 1
  int order = 4;                                ///< shape order of the elements
  double tolerance = 0;                         ///< of the boundary, a length
  std::vector<std::array<int, 2>> layers = {};  ///< by arc and end: intervals that do not move; empty: none anywhere
  std::vector<bool> keeps_count = {};           ///< by chord: its count is prescribed; empty: none is

  int num_layers(int arc, int end) const { return layers.empty() ? 0 : layers[arc][end]; }
  bool may_raise(int chord) const { return keeps_count.empty() || !keeps_count[chord]; }
};

}  // namespace quadrille::growth
