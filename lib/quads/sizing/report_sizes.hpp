#pragma once
// Reports achieved and prescribed edge lengths.

#include <vector>

#include "base/report.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// The element edges on the arcs of one chord, or of all chords; lengths are arc lengths.
struct EdgeSizes {
  double length = 0;                           ///< of all edges
  double prescribed = 0;                       ///< geometric mean over the length
  double least = 0, greatest = 0;              ///< achieved
  double mean_log = 0;                         ///< of ln(achieved / prescribed), over the length
  double deviation = 0;                        ///< its root mean square
  double least_ratio = 0, greatest_ratio = 0;  ///< of achieved / prescribed
};

/// One entry for each chord, then one for all chords.
std::vector<EdgeSizes> edge_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions,
                                  const SizeField& sizes);

/// Sets sizes.* (the chords as columns, sizes.chord.*) and issues a warning for prescribed counts that had to be
/// raised.
void report_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions, const SizeField& sizes,
                  const std::vector<ChordCount>& prescribed, Report& report);

}  // namespace quadrille::sizing
