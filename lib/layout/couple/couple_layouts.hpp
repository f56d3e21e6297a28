#pragma once
// The layout of a face of several regions from those of its regions (lib/method.md §11).

#include <vector>

#include "base/report.hpp"
#include "couple/region_layouts.hpp"
#include "layout/layout_options.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::couple {

/// Joins the layouts: lines that end on an interface near each other are bent to meet (couple/meet_stations.hpp), the
/// others end in T-junctions of one T-mesh (couple/join_layouts.hpp), integer lengths are found for its arcs
/// (quantize/quantize.hpp), and each line goes on in the neighbour through its integer grid
/// (quantize/extend_lines.hpp). Also of one region, with slits. Reports couple.*. Throws ComputeError if there are no
/// integer lengths, or lines cannot be continued.
SeparatrixGraph couple_layouts(RegionLayouts regions, const layout::LayoutOptions& options, Report& report);

}  // namespace quadrille::couple
