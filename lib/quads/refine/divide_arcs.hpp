#pragma once
// The number of elements of each chord, and their ends on each arc.
//
// A chord's count starts from its plan (sizing/grade_chords), with elements that are equal by its grading. Then every
// boundary arc is checked: the order-N polynomial through an interval's Gauss-Lobatto-Legendre points (by arc length)
// must stay within `tolerance` of the curve. If it does not, elements end at the breaks of the curve (joints inside the
// side, jumps of curvature), or become shorter. All arcs of the chord have the same segments between breaks; a break
// opposite another (refine/chord_division) needs no additional element. Elements always end where a curve of a given
// name ends.
//
//   the interval that misses the tolerance                                   correction
//   contains breaks: at most two, or all in less than half of its length     elements end at them; at one of those that
//                                                                            nearly coincide
//   but if all are near its ends and the rest misses the tolerance as well   as if it contained none
//   else, in a chord whose elements stay equal (slope 0, no relaxation)      its segment gets more elements
//   else                                                                     this interval alone becomes shorter
//
// Elements that end at two breaks, or a break and an end, that are near each other are thin, so they come last. An
// interval over which many breaks are spread is too long to be cured at the breaks: it must become shorter first. In
// a graded chord other intervals may be far shorter already. The error of a smooth interval falls with its length to
// the power N + 1, which determines how much shorter it must be; no step replaces one interval by more than four.

#include <vector>

#include "base/progress.hpp"
#include "model/periodic.hpp"
#include "refine/chord_division.hpp"

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

/// The number of intervals that a chord with this plan gets. Throws as divide_arcs.
int divided_count(const sizing::MeasuredLayout& measured, int chord, const sizing::ChordPlan& plan,
                  const DivideOptions& options);

/// Replaces rising fractions from 0 to 1 of both arcs, each in the arc's own direction, by their means; lists of
/// different lengths are not changed. Both arcs belong to one chord, so they have the same number of elements; their
/// own divisions differ where the blocks beside them do.
void match_fractions(const PeriodicArcs& arcs, std::vector<double>& first, std::vector<double>& second);

/// The divisions of all pairs, and the nodes of arcs with layers (by arc; empty where they follow from the
/// division, and for all arcs of a mesh without layers).
void match_periodic(const std::vector<PeriodicArcs>& pairs, sizing::ArcDivisions& divisions,
                    std::vector<std::vector<double>>& layered_nodes);

}  // namespace quadrille::refine
