#pragma once
// Builds the planar graph from finished lines: crossings become nodes, lines and boundary curves are split into arcs.

#include <string>
#include <vector>

#include "graph/crossings.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// An end of a line: a fixed node, a position on the boundary, or neither: then the line ends on another line, at a
/// crossing at the end of the spline's domain.
struct LineEnd {
  int node = -1;
  int curve = -1;
  double t = 0;
  bool is_on_line() const { return node < 0 && curve < 0; }
};

struct FinishedLine {
  LineEnd start, end;
  Nurbs spline;  ///< a non-rational cubic from the first end to the second
  LineKind kind = LineKind::traced;
};

/// `fixed`: irregular nodes, corners and irregular points of the boundary, which do not depend on the lines.
/// Nodes in this order: fixed ones, line ends on the boundary by (curve, t), crossings by (line, parameter). Ends
/// within `snap` (a length) of a fixed node on the boundary or of a joint are moved to it, ends within `snap` of each
/// other are one node, crossings within `snap` of each other on one line too. `crossings`: of the lines' splines.
/// Throws ComputeError if a line passes through the end of another; one that ends ON another makes a T-junction.
SeparatrixGraph build_graph(const CadFace& face, const std::vector<GraphNode>& fixed, std::vector<FinishedLine> lines,
                            const std::vector<Crossing>& crossings, double snap);

}  // namespace quadrille::graph
