#pragma once
// Motorcycle graph (Eppstein, Goodrich, Kim and Tamstorf 2008, "Motorcycle graphs: canonical quad mesh partitioning";
// lib/method.md §9.5): fronts start at the nodes together, advance at equal speed, and each stops at the first crossing
// with another trail, or its own, that reached the crossing before. The result is a mesh with T-junctions whose faces
// have four corners, also if lines spiral.

#include <limits>
#include <vector>

#include "trace/merged_lines.hpp"

namespace quadrille::quantize {

/// A line by arc length. One front starts at 0; a merged line has another one that starts at `length` and runs back.
struct MotorcycleTrail {
  double length = 0;
  bool from_both_ends = false;
  double head_start = 0;  ///< of its fronts, a length: some cuts exist before the lines that they cut
};

/// The part of a trail that its fronts have covered: all of it if first is infinite; else [0, first] and, if last is
/// not infinite, [last, length].
struct CoveredPart {
  double first = 0, last = 0;
  bool is_whole() const { return first == std::numeric_limits<double>::infinity() || first >= last; }
};

/// The covered part of each trail. `crossings`: of the trails, Crossing::s and t being arc lengths. Fronts whose
/// arrivals differ by no more than `tie` (a length) both pass, so that symmetric shapes stay symmetric: a regular
/// crossing of two lines. If the same two trails tie a second time, the one that arrives last stops, so that the
/// process ends.
std::vector<CoveredPart> trace_motorcycle_graph(const std::vector<MotorcycleTrail>& trails,
                                                const std::vector<graph::Crossing>& crossings, double tie);

/// The parts of lines that a motorcycle graph keeps, and the crossings between them.
struct ClippedLines {
  std::vector<graph::FinishedLine> pieces;
  std::vector<int> piece2line;             ///< the line of each piece; a line stopped from both ends has two pieces
  std::vector<graph::Crossing> crossings;  ///< Crossing::a and b number the pieces
};

/// The covered part of each line of the arrangement. A piece that was stopped ends on the line that stopped it.
ClippedLines clip_lines(const trace::LineArrangement& arrangement, const std::vector<CoveredPart>& covered);

}  // namespace quadrille::quantize
