#pragma once
// The layout of separatrices that stop at each other and are continued by an integer program.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"
#include "model/arc_graph.hpp"
#include "model/critical_points.hpp"

namespace quadrille::layout {

/// What other nodes may resolve a strip of faces that contains itself: the integer lengths of such a T-mesh are zero
/// (lib/method.md §9.6), and only critpoints, which chose the nodes, can change that.
/// Options of critpoints, each to be tried alone and in this order, the most sparing first:
///   --corner-absorb 0          if a corner on the strip absorbed nodes
///   --ties field               if the valence of a corner on the strip was chosen at a tie
///   --place energy             if the strip has irregular nodes that may be moved
///   --corner-valence A:B=V     a corner on the strip emits a node, of valence 5 if it is reflex, else 3: V is one less
///                              or one more, and admissible (guide/valence.hpp); the four that add the
///                              least angle defect (guide/valence.hpp)
/// `strip_arcs`: the arcs along the strip (quantize::infeasibility_certificate); nodes at their ends lie on it.
std::vector<std::string> strip_remedies(const ArcGraph& t_mesh, const std::vector<int>& strip_arcs,
                                        const CriticalPoints& points);

/// Computes the T-mesh of stopped lines (quantize/t_mesh.hpp), integer lengths for its arcs (quantize/quantize.hpp),
/// its lines continued through the integer grids of its faces (quantize/quantize_and_extend.hpp), and chord collapse
/// (simplify/simplify.hpp). If no positive lengths exist, merges along the strip that forbids them are rejected, one
/// set after another. Reports t_mesh.*, quantize.* and simplify.*. Throws ComputeError with a position if there is no
/// layout; then quantize.remedies are the options of critpoints that may help (strip_remedies).
graph::CandidateLayout quantized_layout(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                                        const LayoutOptions& options, Report& report);

}  // namespace quadrille::layout
