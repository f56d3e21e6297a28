#pragma once
// Where the intervals of one arc end, once the counts of the chord's segments are known.

#include "refine/chord_division.hpp"

namespace quadrille::refine {

struct PlacedIntervals {
  sizing::ArcDivision division;
  double longest = 0;  ///< longest interval over the one that the plan has at its place on the chord's longest arc
};

/// Arc i of the chord, in its own direction: its own breaks are met to the last digit; between them elements are equal
/// by the chord's grading.
PlacedIntervals place_intervals(const ChordTask& task, const ChordDivision& division, int i);

}  // namespace quadrille::refine
