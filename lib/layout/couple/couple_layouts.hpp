#pragma once
// The layout of a face of several regions from those of its regions (lib/method.md §11).

#include <vector>

#include "base/report.hpp"
#include "couple/region_layouts.hpp"
#include "layout/layout_options.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::couple {

/// The layout of one region that shares no curve and has no periodic sides is that of the whole, as it is. Others are
/// joined: lines that end on an interface near each other are bent to match (couple/match_line_ends.hpp), the others
/// are continued in the neighbour (couple/continue_lines.hpp) or end in T-junctions of one T-mesh
/// (couple/join_layouts.hpp), from which integer lengths make a conforming layout (couple/conforming_layout.hpp).
/// Reports couple.* and simplify.*. Throws ComputeError if there are no integer lengths, or lines cannot be continued.
SeparatrixGraph couple_layouts(RegionLayouts regions, const layout::LayoutOptions& options, Report& report);

}  // namespace quadrille::couple
