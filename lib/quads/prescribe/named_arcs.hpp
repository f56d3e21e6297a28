#pragma once
// The arcs of a layout along a boundary or interface of a name.

#include <string>
#include <vector>

#include "model/arc_graph.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::prescribe {

/// In the direction of their curves, with the face on the left; by curve, then in ascending sequence along it. Both
/// sides of an open interface are in the list, of NAME@REGION the one of that region. Throws UsageError, with `option`
/// at the beginning, for a name that no curve has and where an arc only partly follows the boundary, because a block's
/// side passes its end.
std::vector<HalfEdge> named_arcs(const sizing::MeasuredLayout& measured, const std::string& name,
                                 const std::string& option);

}  // namespace quadrille::prescribe
