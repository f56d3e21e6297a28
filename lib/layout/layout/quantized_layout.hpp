#pragma once
// The layout of separatrices that stop at each other and are continued by an integer program.

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "model/critical_points.hpp"

namespace quadrille::layout {

/// Computes the T-mesh of stopped lines (quantize/t_mesh.hpp), integer lengths for its arcs (quantize/quantize.hpp),
/// its lines continued through the integer grids of its faces (quantize/extend_lines.hpp), and chord collapse
/// (simplify/simplify.hpp). If no positive lengths exist, merges along the strip that forbids them are rejected, one
/// set after another. Reports t_mesh.*, quantize.* and simplify.*. Throws ComputeError with a position if there is no
/// layout; then quantize.remedies are the options of critpoints that may help (layout/strip_remedies.hpp).
graph::CandidateLayout quantized_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                        const LayoutOptions& options, Report& report);

}  // namespace quadrille::layout
