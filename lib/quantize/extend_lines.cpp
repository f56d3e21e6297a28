#include "quantize/extend_lines.hpp"

#include <utility>

#include "graph/face_corners.hpp"
#include "quantize/draw_iso_lines.hpp"
#include "quantize/split_arcs.hpp"

namespace quadrille::quantize {
namespace {

// Copies the T-mesh without its arcs and lines.
SeparatrixGraph without_arcs(const graph::CandidateLayout& t_mesh) {
  SeparatrixGraph graph;
  graph.provenance = t_mesh.provenance;
  graph.face = t_mesh.graph().face;
  graph.certificate = t_mesh.certificate;
  graph.splines = t_mesh.graph().splines;
  graph.nodes = t_mesh.graph().nodes;
  return graph;
}

void add_split_lines(const std::vector<SeparatrixLine>& lines, const SplitArcs& split, SeparatrixGraph& graph) {
  for (SeparatrixLine line : lines) {
    std::vector<int> arcs;
    for (const int a : line.arcs) arcs.insert(arcs.end(), split.parts[a].begin(), split.parts[a].end());
    line.arcs = std::move(arcs);
    graph.lines.push_back(std::move(line));
  }
}

}  // namespace

graph::CandidateLayout extend_lines(const graph::CandidateLayout& layout, const std::vector<TFace>& faces,
                                    const std::vector<int>& lengths) {
  const ArcGraph& t_mesh = layout.graph();
  const curve::CurveTable table(t_mesh.face, t_mesh.splines);
  std::vector<curve::Chain> chains;
  std::vector<double> arc_lengths;
  for (const GraphArc& arc : t_mesh.arcs) {
    chains.emplace_back(table, arc.pieces);
    arc_lengths.push_back(chains.back().length());
  }
  const QuantizedParametrization parametrization(t_mesh, faces, lengths, std::move(arc_lengths));
  SeparatrixGraph graph = without_arcs(layout);
  const SplitArcs split = split_arcs(t_mesh, chains, parametrization.crossing_fractions(), graph);
  add_split_lines(layout.lines, split, graph);
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    draw_iso_lines(t_mesh, parametrization, split, table, f, graph);
  graph::CandidateLayout extended = graph::candidate_layout(std::move(graph), layout.num_built);
  graph::require_four_corners(extended.subdivision);
  return extended;
}

}  // namespace quadrille::quantize
