#pragma once
// Reports achieved and prescribed edge lengths.

#include <vector>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::sizing {

/// Sets sizes.* (the chords as columns, sizes.chord.*) and issues a warning for prescribed counts that had to be
/// raised.
void report_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions, const SizeField& sizes,
                  const std::vector<ChordCount>& prescribed, Report& report);

/// Sets resolution.* (mesh/element_sizes; each chord's part of E). If vertices were moved to the prescribed sizes, a
/// ratio above 5 issues a warning that names the worst chord. xi1 and xi2 of elements run along the sides 0 and 1 of
/// their blocks.
void report_resolution(const MeasuredLayout& measured, const ArcDivisions& divisions, const QuadMesh& mesh,
                       bool is_relaxed_to_sizes, Report& report);

}  // namespace quadrille::sizing
