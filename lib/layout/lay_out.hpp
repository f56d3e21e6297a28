#pragma once
// The ways from a guiding field to a graph of blocks, and the sequence in which they are tried.

#include "layout/trace_separatrices.hpp"

namespace quadrille::layout {

/// options.layout:
/// - "traced": trace_separatrices, whole lines.
/// - "quantized": the T-mesh of stopped lines, integer lengths for its arcs, and what the lines cut when they go on
///   through the integer grid (TMeshTracer, quantize, extend_lines).
/// - "auto": traced; quantized where that has no layout, or where more than 500 lines start, with a warning that says
///   why. Where traced gives more than 1.2 blocks for each line, quantized is tried as well and taken where it has
///   fewer, none of them worse. Certificate and report say which way was taken and why.
/// - "t-mesh": the T-mesh as it is, with T-junctions: to look at.
/// Throws ComputeError where there is no layout.
SeparatrixGraph lay_out(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                        const LayoutOptions& options, Report& report);

}  // namespace quadrille::layout
