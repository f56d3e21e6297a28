#pragma once
// The stage separatrix: the planar graph of separatrices and boundary, whose faces become blocks.

#include <optional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "layout/layout_options.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/separatrix_graph.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

/// With the member `coarse_mesher` of LayoutOptions, which is no option of a command: triangulate::coarse_triangles
/// makes midpoint division possible, by CGAL. Without it, --layout auto ends with a ComputeError where it would divide.
struct SeparatrixOptions : layout::LayoutOptions {
  std::vector<std::string> open;        ///< names of curves
  std::vector<std::string> interfaces;  ///< NAME=nonconforming
  std::vector<std::string> symmetry;    ///< names or patterns (stage/symmetry_option.hpp)
};
void declare(Options& options, SeparatrixOptions& separatrix);

/// The graph with its certificate, of all regions. `points`: nodes of the field; not used, and not needed, with the
/// layout `midpoint`. Throws FormatError if an input breaks a rule or these are not the nodes of the field, UsageError
/// for options outside their intervals or names of no curve, ComputeError if there is no such layout.
SeparatrixGraph separatrix(const Input<Field>& field, const std::optional<Input<CriticalPoints>>& points,
                           const SeparatrixOptions& options, Run& run);

/// The same without a field: midpoint division. Throws UsageError for layouts that need a field.
SeparatrixGraph separatrix(const Input<TriMesh>& triangles, const SeparatrixOptions& options, Run& run);

/// Why the field does not have these nodes and must be solved for them (fieldsolve with nodes); empty if it has them.
/// Throws FormatError if they break a rule that no field could keep.
std::string reason_to_solve_for(const Input<CriticalPoints>& points, const Input<Field>& field);

}  // namespace quadrille::stage
