#pragma once
// From irregular nodes and corners to the planar graph of separatrices and boundary.

#include <string>

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "model/separatrix_graph.hpp"
#include "trace/simplify.hpp"

namespace quadrille {

struct TraceOptions {
  std::string integrator = "rk";  ///< "rk": advance(); "ab4": the paper's, advance_adams_bashforth(), for comparison
  double tolerance = 1e-10;       ///< of the integrator: bound of a step's estimated error, as a share of the diameter
  double step = 0;  ///< of the integrator in file units: the greatest, 0: diameter / 20; of ab4 each, 0: diameter / 500
  /// Degrees: head-on lines are merged where that turns neither by more. On all benchmark shapes 15 removes most thin
  /// strips of blocks and leaves the least scaled Jacobian of the mesh as good as without.
  double merge_angle = 15;
  double merge_distance = 0;        ///< file units: and where their fronts meet within it
  std::string simplify = "normal";  ///< collapse of chords: "none", "normal", "coarsest"
  double max_turn = 40;             ///< degrees: of a line from the field, by that; `coarsest` allows 45 at least
  int max_lines = 2000;             ///< more arcs of separatrices than this is an error
  double max_length = 20;           ///< of one line, in diameters
  /// "traced", "quantized", "auto" or "t-mesh" (trace/lay_out.hpp).
  std::string layout = "auto";
  void validate() const;  ///< throws UsageError
};

/// What options.simplify stands for.
SimplifyOptions simplify_options(const TraceOptions& options);

/// Launches, advances, merges, intersects, builds the graph, takes its census and simplifies it (trace/simplify.hpp).
/// Every line is followed to its end before any merge is decided: the result does not depend on the sequence of the
/// lines or on a step. A domain between two loops in which nothing launches gets four cuts from the inner loop to the
/// outer one, at equal shares of the inner loop's length from the start of its first curve. Throws ComputeError when a
/// bound is met or a face is not four-sided, with the place.
SeparatrixGraph trace_separatrices(const FieldEvaluator& evaluator, const CriticalPoints& points,
                                   const TraceOptions& options, Report& report);

}  // namespace quadrille
