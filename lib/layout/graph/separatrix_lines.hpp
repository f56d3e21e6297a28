#pragma once
// Lines of separatrices from the splines of a graph, while every inner arc is a part of one spline.

#include <string>
#include <vector>

#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// The kind of the line of each spline; traced where none uses it.
std::vector<LineKind> spline_kinds(const ArcGraph& graph, const std::vector<SeparatrixLine>& lines);

/// For each spline a line for each run of arcs, of the kind that `kinds` has for the spline.
std::vector<SeparatrixLine> lines_of_arcs(const ArcGraph& graph, const std::vector<LineKind>& kinds);

}  // namespace quadrille::graph
