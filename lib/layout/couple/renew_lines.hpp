#pragma once
// The records of lines of regions whose graphs changed.

#include <vector>

#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// For each region the kinds of the lines of its splines, before a change.
std::vector<std::vector<LineKind>> kinds_of_lines(const RegionLayouts& regions);

/// The lines again: splines that were added are of the kind `added`. Removes splines that no arc uses.
void renew_lines(RegionLayouts& regions, std::vector<std::vector<LineKind>> kinds, LineKind added);

/// The same of one layout. `kinds`: of its splines before the change.
void renew_lines(graph::CandidateLayout& layout, std::vector<LineKind> kinds, LineKind added);

}  // namespace quadrille::couple
