#pragma once
// Computes the planar graph of separatrices and boundary from irregular nodes and corners.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "model/critical_points.hpp"

namespace quadrille::layout {

/// Traces every separatrix to its end, merges head-on pairs (trace/merged_lines.hpp), intersects the lines, builds the
/// graph, ends lines on small fillets (simplify/line_ends.hpp) where that makes better blocks, and collapses thin
/// chords (simplify/simplify.hpp). All lines are traced before any merge is decided: the result does not depend on the
/// order of the lines or on a step. A domain between two loops in which no separatrix starts is divided by four cuts
/// (trace::launch_cuts). Reports trace.*, fillets.lines_moved and simplify.*. Throws ComputeError, if possible with a
/// position, if a line has no end, a bound is exceeded (for max_lines: graph::CrowdedLinesError) or a face does not
/// have four corners.
graph::CandidateLayout trace_separatrices(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                          const LayoutOptions& options, Report& report);

}  // namespace quadrille::layout
