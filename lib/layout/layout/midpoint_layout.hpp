#pragma once
// The layout that needs no field (midpoint/midpoint_graph.hpp).

#include <string>

#include "base/report.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "midpoint/midpoint_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::layout {

/// The layout without its certificate. With a mesher, it cannot fail for a mesh that keeps the rules of its format.
graph::CandidateLayout midpoint_layout(const TriMesh& mesh, const midpoint::CoarseMesher& mesher, Report& report);

/// The reason for a midpoint division of a file that has triangles but no field; empty if it was chosen. Throws
/// UsageError for a layout that needs a field.
std::string reason_without_field(LayoutChoice choice);

/// Sets the certificate. If the reason is not empty, a warning states it.
void certify_midpoint(graph::CandidateLayout& layout, const std::string& reason, Report& report);

}  // namespace quadrille::layout
