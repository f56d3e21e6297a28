#pragma once
// The layout of a face of several regions from those of its regions (lib/method.md §11), or, where no lines can be
// coupled, midpoint division.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "couple/region_layouts.hpp"
#include "layout/layout_options.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::couple {

/// The layout of one region that shares no curve and has no periodic sides is that of the whole, as it is. Others are
/// joined: lines that end on an interface near each other are bent to match (couple/side_pairs.hpp), the others
/// are continued in the neighbour (couple/continue_lines.hpp) or end in T-junctions of one T-mesh
/// (couple/join_layouts.hpp), from which integer lengths make a conforming layout (couple/conforming_layout.hpp).
/// Where there are none, this is tried once more with lines that may bend by up to greatest_forced_bend. Reports
/// couple.* and simplify.*. Throws ComputeError if there are no integer lengths, or lines cannot be continued.
SeparatrixGraph couple_layouts(RegionLayouts regions, const layout::LayoutOptions& options, Report& report);

/// Divides coarse triangles of the whole face, which have the same edges on both sides of interfaces and slits, into
/// three blocks each (lib/method.md §9.9). `face`: that of `mesh`, without the partners of open interfaces. `reason`:
/// why there is no other layout; if it is not empty, a warning states it. A face of one region without slits is divided
/// by layout/midpoint_layout.hpp. Throws ComputeError if there are no such triangles, or if periodic sides have
/// different nodes.
SeparatrixGraph midpoint_regions(const CadFace& face, const TriMesh& mesh, const layout::CoarseMesher& mesher,
                                 const std::string& reason, Report& report);

/// The same for a file that has triangles but no field. With "auto" there is a warning; throws UsageError for a layout
/// that needs a field.
SeparatrixGraph layout_without_field(const CadFace& face, const TriMesh& mesh, const layout::LayoutOptions& options,
                                     Report& report);

/// couple_layouts; with "auto" and a coarse mesher, midpoint division of `mesh`, that of the whole, if the layouts
/// cannot be coupled.
SeparatrixGraph couple_or_divide(RegionLayouts regions, const TriMesh& mesh, const layout::LayoutOptions& options,
                                 Report& report);

}  // namespace quadrille::couple
