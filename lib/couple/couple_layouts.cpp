#include "couple/couple_layouts.hpp"

#include <utility>

#include "base/error.hpp"
#include "couple/join_layouts.hpp"
#include "couple/meet_stations.hpp"
#include "couple/turn_round_regions.hpp"
#include "curve/chain.hpp"
#include "graph/face_corners.hpp"
#include "quantize/extend_lines.hpp"
#include "quantize/quantize.hpp"
#include "quantize/t_mesh_faces.hpp"

namespace quadrille::couple {
namespace {

constexpr double relative_unit = 0.1;  // an arc of this length, relative to the diameter, has integer length one

std::vector<double> arc_lengths(const ArcGraph& graph) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  for (const GraphArc& arc : graph.arcs) lengths.push_back(curve::Chain(table, arc.pieces).length());
  return lengths;
}

graph::CandidateLayout conforming(const graph::CandidateLayout& t_mesh) {
  const ArcGraph& graph = t_mesh.graph();
  const std::vector<quantize::TFace> faces = quantize::t_mesh_faces(t_mesh.subdivision);
  const quantize::Quantization found =
      quantize::quantize_or_explain(faces, arc_lengths(graph), relative_unit * graph.face.diameter);
  if (found.lengths.empty())
    throw ComputeError(
        "the lines of the regions cannot be continued across their interfaces: a strip of blocks winds onto itself; "
        "mesh the regions alone (cad2tri --face)");
  return quantize::extend_lines(t_mesh, faces, found.lengths);
}

}  // namespace

SeparatrixGraph couple_layouts(RegionLayouts regions, Report& report) {
  report.set("couple.turned_regions", turn_round_regions(regions));
  report.set("couple.lines_met", meet_stations(regions));
  graph::CandidateLayout layout = graph::candidate_layout(join_layouts(regions));
  report.set("couple.t_junctions", layout.t_junctions.size());
  report.set("couple.faces_before", layout.subdivision.num_faces());
  if (!layout.t_junctions.empty()) layout = conforming(layout);
  report.set("couple.faces", graph::require_four_corners(layout.subdivision));
  graph::require_drawn_in_order(layout.subdivision);
  return graph::separatrix_graph(std::move(layout));
}

}  // namespace quadrille::couple
