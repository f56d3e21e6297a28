#pragma once
// The number of elements of each chord, and their ends on each arc.
//
// A chord's count starts from its plan (sizing/grade_chords), with elements that are equal by its grading. Then every
// boundary arc is checked: the order-N polynomial through an interval's Gauss-Lobatto-Legendre points (by arc length)
// must stay within `tolerance` of the curve. If it does not, elements end at the breaks of the curve (joints inside the
// side, jumps of curvature), or become shorter (refine/correct_misses has the rules). All arcs of the chord have the
// same segments between breaks; a break opposite another (refine/anchors) needs no additional element. Elements always
// end where a curve of a given name ends.

#include <vector>

#include "base/progress.hpp"
#include "refine/place_intervals.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// The result of an earlier call with the same layout and options, and the plans that it was made from.
struct KnownDivisions {
  const std::vector<sizing::ChordPlan>* plans = nullptr;
  const sizing::ArcDivisions* divisions = nullptr;
};

/// The divisions of all arcs; arcs of one chord get the same number of intervals, between breaks equal by the chord's
/// grading and the parameters of the arcs. If segments between breaks do not divide well, intervals may be longer by a
/// quarter than planned; prescribed counts are raised only if breaks and tolerance cannot be met otherwise. `plans`:
/// one per chord. Chords whose plan is the `known` one keep their divisions. Throws ComputeError with the position if a
/// chord would need more than 10000 intervals.
sizing::ArcDivisions divide_arcs(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordPlan>& plans,
                                 const DivideOptions& options, Progress* progress = nullptr,
                                 const KnownDivisions& known = {});

}  // namespace quadrille::refine
