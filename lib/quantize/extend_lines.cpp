#include "quantize/extend_lines.hpp"

#include <utility>

#include "graph/planar_faces.hpp"
#include "quantize/draw_iso_lines.hpp"
#include "quantize/split_arcs.hpp"

namespace quadrille::quantize {
namespace {

// All of the T-mesh but its arcs and lines.
SeparatrixGraph without_arcs(const SeparatrixGraph& t_mesh) {
  SeparatrixGraph graph;
  graph.provenance = t_mesh.provenance;
  graph.face = t_mesh.face;
  graph.certificate = t_mesh.certificate;
  graph.splines = t_mesh.splines;
  graph.nodes = t_mesh.nodes;
  return graph;
}

void add_split_lines(const SeparatrixGraph& t_mesh, const SplitArcs& split, SeparatrixGraph& graph) {
  for (SeparatrixLine line : t_mesh.lines) {
    std::vector<int> arcs;
    for (const int a : line.arcs) arcs.insert(arcs.end(), split.parts[a].begin(), split.parts[a].end());
    line.arcs = std::move(arcs);
    graph.lines.push_back(std::move(line));
  }
}

}  // namespace

SeparatrixGraph extend_lines(const SeparatrixGraph& t_mesh, const std::vector<TFace>& faces,
                             const std::vector<int>& lengths) {
  const curve::CurveTable table(t_mesh.face, t_mesh.splines);
  std::vector<curve::Chain> chains;
  std::vector<double> arc_lengths;
  for (const GraphArc& arc : t_mesh.arcs) {
    chains.emplace_back(table, arc.pieces);
    arc_lengths.push_back(chains.back().length());
  }
  const QuantizedParametrization parametrization(t_mesh, faces, lengths, std::move(arc_lengths));
  SeparatrixGraph graph = without_arcs(t_mesh);
  const SplitArcs split = split_arcs(t_mesh, chains, parametrization.crossing_fractions(), graph);
  add_split_lines(t_mesh, split, graph);
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    draw_iso_lines(t_mesh, parametrization, split, table, f, graph);
  graph::require_four_corners(graph);
  return graph;
}

}  // namespace quadrille::quantize
