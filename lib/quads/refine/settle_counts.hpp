#pragma once
// The number of elements of a chord: the least count that suits all of its arcs.

#include "refine/place_intervals.hpp"

namespace quadrille::refine {

/// The division before any arc was tried: least count, and anchors at the breaks of boundary arcs, of which only the
/// ends of curves with a given name are required. Counts and arcs are not filled in. Throws ComputeError for a plan of
/// more than `max_intervals`.
ChordDivision begin_division(const ChordTask& task);

/// Finds the least count that suits all arcs and fills in counts and arcs. A count suits if equal segments have equal
/// counts (at least among the first 24 counts) and no interval is longer than planned by more than a quarter; a
/// prescribed count always suits. Throws ComputeError with a position if it would exceed `max_intervals`.
void settle_counts(const ChordTask& task, ChordDivision& division);

}  // namespace quadrille::refine
