#pragma once
// Adjacent intervals of a division, inside arcs and across nodes, and the ratios of their lengths.

#include <vector>

#include "growth/growth_input.hpp"

namespace quadrille::growth {

/// Interval k of an arc, between its ends k and k + 1.
struct Interval {
  int arc = 0, k = 0;
};

struct IntervalPair {
  Interval a, b;
};

/// All pairs of which at least one may change: consecutive ones of each arc, then those across nodes, on both sides of
/// an arc between two blocks (mesh/block_sides). Layers do not change.
std::vector<IntervalPair> adjacent_intervals(const GrowthInput& input, const sizing::ArcDivisions& divisions);

/// Whether an interval is one of the layers at an end of its arc.
bool is_layer(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Interval& interval);

double length_of(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Interval& interval);

/// ln of the length of b over that of a.
double log_growth(const GrowthInput& input, const sizing::ArcDivisions& divisions, const IntervalPair& pair);

}  // namespace quadrille::growth
