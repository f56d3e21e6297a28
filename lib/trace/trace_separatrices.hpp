#pragma once
// From irregular nodes and corners to the planar graph of separatrices and boundary.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille {

struct TraceOptions {
  double tolerance = 1e-10;      ///< of the integrator, as a share of the diameter
  double step = 0;               ///< synchronous step in file units; 0: diameter / 200
  double merge_distance = 0;     ///< in file units; 0: the normal rule
  int max_lines = 2000;          ///< more lines (arcs of separatrices) than this is an error
  double max_length = 20;        ///< of one line, in diameters
  void validate() const;         ///< throws UsageError
};

/// Launches, advances all lines together, merges, intersects, builds the graph and takes its census.
/// Throws ComputeError when a bound is met or a face is not four-sided, with the place.
SeparatrixGraph trace_separatrices(const FieldEvaluator& evaluator, const CriticalPoints& points,
                                   const TraceOptions& options, Report& report);

}  // namespace quadrille
