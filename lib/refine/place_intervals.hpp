#pragma once
// The ends of the intervals of one arc, given the counts of the chord's segments.

#include "refine/chord_division.hpp"

namespace quadrille::refine {

struct PlacedIntervals {
  sizing::ArcDivision division;
  double longest = 0;  ///< longest interval over the planned one at its position on the chord's longest arc
};

/// Arc i of the chord, in its own direction: its own breaks are met to the last digit; between them elements are equal
/// by the chord's grading.
PlacedIntervals place_intervals(const ChordTask& task, const ChordDivision& division, int i);

}  // namespace quadrille::refine
