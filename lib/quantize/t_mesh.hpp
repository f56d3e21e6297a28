#pragma once
// The T-mesh of a guiding field: separatrices, each as long as the first line that was laid across its way before
// (motorcycle.hpp). It is finite for every field, spirals and limit cycles included, and all its faces are four-sided:
// corners of one quarter turn at crossings and line ends, T-junctions on the sides.

#include <memory>
#include <vector>

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "model/separatrix_graph.hpp"
#include "quantize/t_mesh_faces.hpp"
#include "trace/trace_options.hpp"

namespace quadrille::quantize {

/// Separatrices that meet head on are merged as in trace_separatrices, then all race. A hole that no line reaches is
/// tied to the rest by a cut, and so is a limit cycle that crosses nobody. Lines are followed no farther than needed:
/// the bound doubles from two diameters for those that nothing has stopped.
class TMeshTracer {
 public:
  /// `evaluator` must outlive the tracer. Throws ComputeError as launch_all.
  TMeshTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points, const trace::TraceOptions& options);
  ~TMeshTracer();

  /// Throws ComputeError where a line cannot be followed.
  SeparatrixGraph trace(Report& report);

  /// Gives up the merge that turns most of those that have one of these arcs of the graph traced last, within 1e-6
  /// alike; where none has, of all. Two merges may contradict each other: the one says that two nodes lie on one line
  /// of the grid, the other that they do not. False where none is left.
  bool give_up_merge(const SeparatrixGraph& graph, const std::vector<int>& arcs);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quadrille::quantize
