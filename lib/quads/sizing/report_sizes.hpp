#pragma once
// Reports achieved and prescribed edge lengths.

#include <vector>

#include "base/report.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::sizing {

/// Sets sizes.* (the chords as columns, sizes.chord.*) and issues a warning for prescribed counts that had to be
/// raised.
void report_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions, const SizeField& sizes,
                  const std::vector<ChordCount>& prescribed, Report& report);

}  // namespace quadrille::sizing
