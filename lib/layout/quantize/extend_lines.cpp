#include "quantize/extend_lines.hpp"

#include <utility>

#include "graph/face_corners.hpp"
#include "quantize/draw_iso_lines.hpp"
#include "quantize/split_arcs.hpp"

namespace quadrille::quantize {
namespace {

std::vector<SeparatrixLine> split_lines(std::vector<SeparatrixLine> lines, const ArcParts& parts) {
  for (SeparatrixLine& line : lines) {
    std::vector<int> arcs;
    for (const int a : line.arcs) arcs.insert(arcs.end(), parts[a].begin(), parts[a].end());
    line.arcs = std::move(arcs);
  }
  return lines;
}

}  // namespace

graph::CandidateLayout extend_lines(const graph::CandidateLayout& layout, const std::vector<TFace>& faces,
                                    const std::vector<int>& lengths, const std::vector<HalfEdge>& same) {
  const ArcGraph& t_mesh = layout.graph();
  const curve::CurveTable table(t_mesh.face, t_mesh.splines);
  std::vector<curve::Chain> chains;
  std::vector<double> arc_lengths;
  for (const GraphArc& arc : t_mesh.arcs) {
    chains.emplace_back(table, arc.pieces);
    arc_lengths.push_back(chains.back().length());
  }
  const QuantizedParametrization parametrization(t_mesh, faces, lengths, std::move(arc_lengths), same);
  graph::CandidateLayout extended = layout;
  const ArcParts parts = split_arcs(chains, parametrization.crossing_fractions(), extended.subdivision);
  extended.lines = split_lines(layout.lines, parts);
  extended.t_junctions.clear();
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    draw_iso_lines({t_mesh, table, parametrization, parts}, f, extended);
  extended.subdivision.compact();
  graph::require_four_corners(extended.subdivision);
  graph::require_drawn_in_order(extended.subdivision);
  return extended;
}

}  // namespace quadrille::quantize
