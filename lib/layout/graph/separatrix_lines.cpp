#include "graph/separatrix_lines.hpp"

#include <algorithm>

#include "model/interfaces.hpp"

namespace quadrille::graph {

std::vector<LineKind> spline_kinds(const ArcGraph& graph, const std::vector<SeparatrixLine>& lines) {
  std::vector<LineKind> kinds(graph.splines.size(), LineKind::traced);
  for (const SeparatrixLine& line : lines)
    for (const int arc : line.arcs)
      for (const ArcPiece& p : graph.arcs[arc].pieces) kinds[p.curve - graph.face.num_curves()] = line.kind;
  return kinds;
}

std::vector<SeparatrixLine> lines_of_arcs(const ArcGraph& graph, const std::vector<LineKind>& kinds) {
  std::vector<std::vector<int>> arcs_of(graph.splines.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    if (!is_on_cad_curve(graph, graph.arcs[a]))
      arcs_of[graph.arcs[a].pieces.front().curve - graph.face.num_curves()].push_back(a);
  const auto low = [&](int a) { return std::min(graph.arcs[a].pieces.front().t0, graph.arcs[a].pieces.back().t1); };
  std::vector<SeparatrixLine> lines;
  for (std::size_t i = 0; i < arcs_of.size(); ++i) {
    std::sort(arcs_of[i].begin(), arcs_of[i].end(), [&](int a, int b) { return low(a) < low(b); });
    for (const int a : arcs_of[i]) {
      const GraphArc& arc = graph.arcs[a];
      const bool rises = arc.pieces.front().t0 < arc.pieces.front().t1;
      const int from = rises ? arc.from : arc.to, to = rises ? arc.to : arc.from;
      if (a == arcs_of[i].front() || lines.back().end != from) lines.push_back({from, from, kinds[i], {}});
      lines.back().end = to;
      lines.back().arcs.push_back(a);
    }
  }
  return lines;
}

void rebuild_lines(CandidateLayout& layout, std::vector<LineKind> kinds, LineKind added) {
  kinds.resize(layout.graph().splines.size(), added);
  layout.lines = lines_of_arcs(layout.graph(), kinds);
  layout.subdivision.drop_unused_splines();
}

}  // namespace quadrille::graph
