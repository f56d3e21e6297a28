#pragma once
// The layout that needs no field (midpoint/midpoint_graph.hpp).

#include "base/report.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::layout {

/// The layout without its certificate. Cannot fail for a mesh that keeps the rules of its format.
graph::CandidateLayout midpoint_layout(const TriMesh& mesh, Report& report);

/// The separatrix graph of a file that has triangles but no field, with its certificate. With "auto" there is a
/// warning; throws UsageError for a layout that needs a field.
SeparatrixGraph layout_without_field(const TriMesh& mesh, LayoutChoice choice, Report& report);

}  // namespace quadrille::layout
