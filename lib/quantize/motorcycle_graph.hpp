#pragma once
// Motorcycle graph (Eppstein, Goodrich, Kim and Tamstorf 2008, "Motorcycle graphs: canonical quad mesh partitioning";
// lib/method.md §9.5): fronts start at the nodes together, advance at equal speed, and each stops at the first place
// where another trail, or its own, crosses it and was there before. The result is a mesh with T-junctions whose faces
// have four corners, however many lines spiral.

#include <limits>
#include <vector>

#include "graph/crossings.hpp"

namespace quadrille::quantize {

/// A line by arc length. One front starts at 0; a merged line has another one that starts at `length` and runs back.
struct MotorcycleTrail {
  double length = 0;
  bool from_both_ends = false;
  double head_start = 0;  ///< of its fronts, a length: some cuts exist before the lines that they cut
};

/// What the fronts of a trail have covered: all of it, where first is infinite; else [0, first] and, where last is not
/// infinite, [last, length].
struct CoveredPart {
  double first = 0, last = 0;
  bool is_whole() const { return first == std::numeric_limits<double>::infinity() || first >= last; }
};

/// The covered part of each trail. `crossings`: of the trails, Crossing::s and t being arc lengths. Fronts whose
/// arrivals differ by no more than `tie` (a length) both pass, so that symmetric shapes stay symmetric: a regular
/// crossing of two lines. Where the same two trails tie once more, the one that arrives last stops, so that it ends.
std::vector<CoveredPart> trace_motorcycle_graph(const std::vector<MotorcycleTrail>& trails,
                                                const std::vector<graph::Crossing>& crossings, double tie);

}  // namespace quadrille::quantize
