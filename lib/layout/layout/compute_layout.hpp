#pragma once
// Computes the graph of blocks from a guiding field and its nodes, by the method that the options prescribe.

#include <functional>

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "model/critical_points.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::layout {

using LayoutOfOptions = std::function<graph::CandidateLayout(const LayoutOptions&)>;

/// compute(options); if it throws trace::FamilyOrderError, again with a tolerance 100 times finer, down to 1e-12
/// diameters: where many lines approach one separatrix, their errors are larger than their distances. Reports
/// layout.tolerance if it was changed.
graph::CandidateLayout with_fine_tolerance(LayoutOptions options, Report& report, const LayoutOfOptions& compute);

/// options.layout:
/// - "traced": separatrices are traced to their ends (layout/trace_separatrices.hpp).
/// - "quantized": they stop at each other and are continued by an integer program (layout/quantized_layout.hpp).
/// - "midpoint": triangles, each divided into three blocks (layout/midpoint_layout.hpp).
/// - "auto": one of these three (layout/choose_layout.hpp).
/// - "t-mesh": the T-mesh of stopped lines, with T-junctions: for inspection.
/// The graph contains its certificate, which the report repeats (layout/certificate.hpp). Throws ComputeError if there
/// is no layout, which with options.coarse_mesher cannot happen with "midpoint" and "auto".
SeparatrixGraph compute_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                               const LayoutOptions& options, Report& report);

}  // namespace quadrille::layout
