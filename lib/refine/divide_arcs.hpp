#pragma once
// How many elements each chord gets, and where on each arc they end.
//
// A chord's count starts from its plan (sizing/grade_chords), with elements that are equal by its grading. Then every
// boundary arc is tried: the order-N polynomial through an interval's Gauss-Lobatto-Legendre points (by arc length)
// must stay within `tolerance` of the curve. Where it does not and the interval straddles a break of the curve (a joint
// inside the side, a jump of curvature), an end of an interval moves onto the break; else that segment of the chord
// gets more intervals. All arcs of the chord share the segments; a break that faces another (refine/anchors) costs no
// element of its own. Where a curve of a given name ends, an interval ends in any case.

#include <vector>

#include "curve/chain.hpp"
#include "mesh/chords.hpp"
#include "model/block_layout.hpp"
#include "sizing/arc_parameter.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::refine {

struct DivideOptions {
  int order = 4;         ///< N
  double tolerance = 0;  ///< greatest distance between an interval's polynomial and its curve, > 0, a length
};

/// For each arc the ends of its intervals as fractions of its length, ascending from 0 to 1; arcs of one chord get the
/// same number, between breaks equal by the chord's grading and their `parameters` (refine/align_chords). Where breaks
/// leave segments that do not divide well, intervals may be longer by a quarter than the plan's; counts that were
/// prescribed rise only where the breaks and the tolerance cannot be had otherwise. `chains`, `parameters`: one per
/// arc; `plans`: one per chord. Throws ComputeError when a chord would need more than 10000 intervals, with its place.
std::vector<std::vector<double>> divide_arcs(const BlockLayout& layout, const std::vector<mesh::Chord>& chords,
                                             const std::vector<sizing::ChordPlan>& plans,
                                             const curve::CurveTable& table, const std::vector<curve::Chain>& chains,
                                             const std::vector<sizing::ArcParameter>& parameters,
                                             const DivideOptions& options);

}  // namespace quadrille::refine
