#pragma once
// Corrections for boundary arcs whose intervals miss the tolerance.
//
//   the interval that misses it                                              correction
//   contains breaks: at most two, or all in less than half of its length     elements end at them; at one of those that
//                                                                            nearly coincide
//   but if all are near its ends and the rest misses the tolerance as well   as if it contained none
//   else, in a chord of equal elements                                       its segment gets more elements
//   else, in a graded chord                                                  this interval alone becomes shorter
//
// Elements that end at two breaks, or a break and an end, that are near each other are thin, so they come last. An
// interval over which many breaks are spread is too long to be cured at the breaks: it must become shorter first. In
// a graded chord other intervals may be far shorter already. The error of a smooth interval falls with its length to
// the power N + 1, which determines how much shorter it must be; no step replaces one interval by more than four.

#include <vector>

#include "refine/place_intervals.hpp"

namespace quadrille::refine {

/// The corrections that one arc needs.
struct Corrections {
  std::vector<int> anchors;                              ///< where elements must end
  std::vector<double> worst_errors;                      ///< by segment: greatest error that a higher count corrects
  std::vector<sizing::MaxLengthConstraint> constraints;  ///< on intervals of a graded chord
  bool is_needed = false;                                ///< some interval misses the tolerance
};

Corrections find_corrections(const ChordTask& task, const ChordDivision& division, int i);

/// Applies the corrections of all boundary arcs to the state from which settle_counts starts. Where a segment is cut,
/// no count is raised in the same round: both parts may need none. Returns false if all of them meet the tolerance.
bool correct_misses(const ChordTask& task, ChordDivision& division);

}  // namespace quadrille::refine
