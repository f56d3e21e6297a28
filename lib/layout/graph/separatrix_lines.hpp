#pragma once
// Lines of separatrices from the splines of a graph, while every inner arc is a part of one spline.

#include <string>
#include <vector>

#include "graph/candidate_layout.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// The kind of the line of each spline; traced where none uses it.
std::vector<LineKind> spline_kinds(const ArcGraph& graph, const std::vector<SeparatrixLine>& lines);

/// For each spline a line for each run of arcs, of the kind that `kinds` has for the spline.
std::vector<SeparatrixLine> lines_of_arcs(const ArcGraph& graph, const std::vector<LineKind>& kinds);

/// Sets the lines of a layout whose arcs changed, and removes splines that no arc uses. `kinds`: of its splines before
/// the change; those that were added are of the kind `added`.
void rebuild_lines(CandidateLayout& layout, std::vector<LineKind> kinds, LineKind added);

}  // namespace quadrille::graph
