#pragma once
// The race that ends at the first trail (motorcycle graph; Eppstein, Goodrich, Kim and Tamstorf 2008, "Motorcycle
// graphs: canonical quad mesh partitioning"): fronts start at the nodes together, advance at equal speed, and each
// stops at the first place where another trail, or its own, was laid across its way before. What is left is a mesh with
// T-junctions whose faces have four corners, however many lines spiral.

#include <limits>
#include <vector>

#include "graph/crossings.hpp"

namespace quadrille::quantize {

/// A line by arc length. One front starts at 0; a merged line has another one that starts at `length` and comes back.
struct Trail {
  double length = 0;
  bool from_both_ends = false;
  double head_start = 0;  ///< of its fronts, a length: cuts are there before the lines that they cut
};

/// What the fronts of a trail have covered: all of it, where first is infinite; else [0, first] and, where last is not
/// infinite, [last, length].
struct Covered {
  double first = 0, last = 0;
  bool whole() const { return first == std::numeric_limits<double>::infinity() || first >= last; }
};

/// Crossings of the trails, Crossing::s and t being arc lengths. Fronts whose arrivals differ by no more than `tie`
/// (a length) both pass, so that symmetric shapes stay symmetric: a regular crossing of two lines. Where the same two
/// trails tie once more, the one that comes last stops, so that the race has
/// an end.
std::vector<Covered> race(const std::vector<Trail>& trails, const std::vector<graph::Crossing>& crossings, double tie);

}  // namespace quadrille::quantize
