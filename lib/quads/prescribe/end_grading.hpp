#pragma once
// Prescribed lengths of the first and the last element along a boundary: --grading inlet=0.01:0.05.
//
// From its two ends elements grow (or shrink) by one ratio exp(s) to what the chord has anyway. Along the first arc, at
// the distance x from the end, the length of an element is
//
//   l(x) = l_0 + s x,  l_0 = FIRST s / (exp(s) - 1),
//
// so that the first element ends at x = FIRST. Where the boundary has more arcs, theirs continue l. s is at most
// ln(growth); for a chord it follows from its whole number of elements, the next above the number at the greatest s.
//
// Where the number of elements is prescribed, every number has both lengths: the logarithm of the elements' lengths is
// a function of their number that rises to the middle and falls from there (prescribe/log_spacing), along the whole
// boundary if all its chords have one.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::prescribe {

/// Lengths of the elements at both ends of a boundary, in the direction of its curves (the face on the left); 0: free.
struct EndGrading {
  std::string boundary;
  double first = 0, last = 0;
};

/// "NAME=FIRST:LAST"; throws UsageError.
EndGrading parse_end_grading(const std::string& text);

/// Changes the gradings of the chords along the boundaries, and counts that are not prescribed. `growth`: greatest
/// ratio of neighbouring elements, > 1. Throws UsageError for a name that no curve has, and for a closed boundary,
/// which has no ends.
void apply_end_gradings(const sizing::MeasuredLayout& measured, const std::vector<EndGrading>& gradings, double growth,
                        std::vector<sizing::ChordPlan>& plans);

/// Sets gradings.<n>.boundary, .first and .last, the achieved lengths, and .growth, the greatest ratio of adjacent
/// elements along it. Warns where lengths deviate by more than a fifth from the prescribed ones, and where prescribed
/// `counts` make that ratio exceed the growth by more than a tenth.
void report_end_gradings(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions,
                         const std::vector<EndGrading>& gradings, double growth,
                         const std::vector<sizing::ChordCount>& counts, Report& report);

}  // namespace quadrille::prescribe
