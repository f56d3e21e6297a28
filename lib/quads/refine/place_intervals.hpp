#pragma once
// The division of one chord into elements, the state that refine/divide_arcs improves until every arc meets the
// tolerance; and the ends of the intervals of one arc, given the counts of the chord's segments.
//
// Positions v in [0, 1] count elements: v is the fraction of the chord's elements before a line across the chord
// (sizing/grading: Grading::cumulative).

#include <numeric>
#include <vector>

#include "refine/anchored_segments.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// The requirements on the divisions of arcs.
struct DivideOptions {
  int order = 4;         ///< N, of the elements
  double tolerance = 0;  ///< greatest distance between an interval's polynomial and its curve, > 0, a length
};

/// More intervals than this are an error.
constexpr int max_intervals = 10000;

/// A chord that is to be divided. Arcs are numbered by their position in the chord.
struct ChordTask {
  const sizing::MeasuredLayout& measured;
  const mesh::Chord& chord;
  const sizing::ChordPlan& plan;
  const DivideOptions& options;

  int num_arcs() const { return static_cast<int>(chord.arcs.size()); }
  const curve::Chain& chain(int i) const { return measured.chain(chord.arcs[i]); }
  const GraphArc& arc(int i) const { return measured.blocks().arcs[chord.arcs[i]]; }
};

struct ChordDivision {
  sizing::Grading grading;    ///< of the plan, with shorter elements where a graded chord missed the tolerance
  double planned_count = 1;   ///< elements of the plan, or of the refined grading: a real number
  int least_count = 1;        ///< from plan and topology
  double longest_arc = 0;     ///< a length
  AnchoredSegments anchored;  ///< by v
  std::vector<int> counts;    ///< elements of each segment
  std::vector<sizing::ArcDivision> arcs;

  int count() const { return std::accumulate(counts.begin(), counts.end(), 0); }
};

struct PlacedIntervals {
  sizing::ArcDivision division;
  double longest = 0;  ///< longest interval over the planned one at its position on the chord's longest arc
};

/// Arc i of the chord, in its own direction: its own breaks are met to the last digit; between them elements are equal
/// by the chord's grading.
PlacedIntervals place_intervals(const ChordTask& task, const ChordDivision& division, int i);

}  // namespace quadrille::refine
