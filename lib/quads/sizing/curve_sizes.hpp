#pragma once
// Sizes along curves where none are prescribed.
//
// Where no sizes are prescribed, elements follow the features of a face: those along a run of the boundary of length L
// are max(L / n, s) long, n = SizeField::default_per_curve. A chord has one count in all of its blocks, so that one
// short curve can make the mesh of the whole face many times as large. s is therefore the least for which the counts of
// chords make at most twice as many elements as without this rule. In a far field (model/name_rules) s = 0: the size
// away from the curves is that of the far field, and no measure of the body. Along a wake there, elements grow by 5 %
// from one to the next, from the size at its beginning, where it has the smaller one.

#include "sizing/grade_chords.hpp"
#include "sizing/make_size_field.hpp"

namespace quadrille::sizing {

/// The options with numbers in place of an automatic `per_curve`: n and s by this rule, s to 19 %, or 0 if none is
/// small enough, if a size or a table is prescribed, or if no curve is short; with a wake among the curves with sizes
/// of their own (`near`), unless it is there. Throws UsageError.
SizeOptions with_curve_sizes(const MeasuredLayout& measured, const SizeOptions& options, SizeRule rule);

}  // namespace quadrille::sizing
