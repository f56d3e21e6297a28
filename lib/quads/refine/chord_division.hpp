#pragma once
// The division of one chord into elements, the state that refine/divide_arcs improves until every arc meets the
// tolerance: the least count that suits all arcs, and the ends of the intervals of each.
//
// A break is a point of one arc (a joint, a jump of curvature) that no element should straddle. Breaks of different
// arcs opposite each other have one common anchor: the same line across the chord passes through all of them. Positions
// v in [0, 1] count elements: v is the fraction of the chord's elements before a line across the chord (sizing/grading:
// Grading::cumulative).

#include <functional>
#include <numeric>
#include <vector>

#include "sizing/grade_chords.hpp"

namespace quadrille::refine {

/// A break of one arc of a chord.
struct Break {
  double u = 0;         ///< the chord's parameter there
  double fraction = 0;  ///< of the arc's own length, in its own direction
  int arc = 0;          ///< position in the chord
};

/// A position inside a chord at which elements should end.
struct Anchor {
  double u = 0;               ///< mean of the breaks
  std::vector<Break> breaks;  ///< at most one for each arc
};

/// Sorted by u. Breaks are grouped if their neighbours in u are nearer than `reach`, or than reach / 2, reach / 4, ...
/// if this would group two breaks of one arc, which must differ in u.
std::vector<Anchor> find_anchors(std::vector<Break> breaks, double reach);

/// The segments of a chord between the anchors at which an element must end.
struct AnchoredSegments {
  std::vector<Anchor> anchors;  ///< ascending
  std::vector<int> required;    ///< numbers of anchors, ascending: the inner ends of the segments
  sizing::Segments segments;    ///< positions v in [0, 1]: the fraction of the chord's elements before them
};

/// Makes an anchor an end of segments; nothing changes if it is one already. The count of both parts of the segment
/// that it cuts is reset to one element: the segment may have needed its count only because it contained the break.
void require_anchor(AnchoredSegments& anchored, int anchor);

/// Moves all breaks, their anchors and the ends of the segments to the positions that `position` returns.
void move_breaks(AnchoredSegments& anchored, const std::function<double(const Break&)>& position);

/// The requirements on the divisions of arcs.
struct DivideOptions {
  int order = 4;         ///< N, of the elements
  double tolerance = 0;  ///< greatest distance between an interval's polynomial and its curve, > 0, a length
  /// Where no growth is prescribed (slope 0), an interval that misses the tolerance becomes shorter alone, however long
  /// its neighbours are, for relaxation moves vertices; else all of its segment do.
  bool shortens_single_intervals = false;
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

/// The intervals of arc i of the chord, given the counts of segments: in its own direction; its own breaks are met to
/// the last digit; between them elements are equal by the chord's grading.
PlacedIntervals place_intervals(const ChordTask& task, const ChordDivision& division, int i);

/// The division before any arc was tried: least count, and anchors at the breaks of boundary arcs, of which only the
/// ends of curves with a given name are required. Counts and arcs are not filled in. Throws ComputeError for a plan of
/// more than `max_intervals`.
ChordDivision begin_division(const ChordTask& task);

/// Finds the least count that suits all arcs and fills in counts and arcs. A count suits if equal segments have equal
/// counts (at least among the first 24 counts) and no interval is longer than planned by more than a quarter; a
/// prescribed count always suits, but for ties if it is not by the user. Throws ComputeError with a position if it
/// would exceed `max_intervals`.
void settle_counts(const ChordTask& task, ChordDivision& division);

}  // namespace quadrille::refine
