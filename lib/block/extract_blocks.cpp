#include "block/extract_blocks.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbered_names.hpp"
#include "base/position_text.hpp"
#include "graph/face_corners.hpp"
#include "mesh/chords.hpp"

namespace quadrille::block {
namespace {

void require_conforming(const SeparatrixGraph& graph) {
  if (graph.t_junctions.empty()) return;
  const Vec2 position = graph.nodes[graph.t_junctions.front()].position + graph.face.origin;
  throw ComputeError(
      fmt::format("a separatrix ends on the side of a block at {}; blocks must conform", position_text(position)));
}

}  // namespace

graph::Subdivision subdivision_into_blocks(const SeparatrixGraph& graph) {
  require_conforming(graph);
  graph::Subdivision subdivision(graph);
  if (graph::require_four_corners(subdivision) == 0) throw ComputeError("the graph has no faces");
  return subdivision;
}

BlockLayout blocks_of(const graph::Subdivision& subdivision) {
  BlockLayout layout;
  static_cast<ArcGraph&>(layout) = subdivision.graph();
  for (int f = 0; f < subdivision.face_bound(); ++f) {
    const std::vector<HalfEdge> cycle = subdivision.cycle(f);
    std::array<HalfEdge, 4> arcs;
    std::array<int, 4> nodes{};
    for (int k = 0; k < 4; ++k) arcs[k] = cycle[k], nodes[k] = subdivision.start(cycle[k]);
    layout.block2arcs.push_back(arcs);
    layout.block2nodes.push_back(nodes);
    layout.block_names.emplace_back();
  }
  layout.unnamed_blocks = replace_empty_names(layout.block_names, "block");
  layout.arc_chord = mesh::arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()));
  return layout;
}

BlockLayout extract_blocks(const SeparatrixGraph& graph) {
  BlockLayout layout = blocks_of(subdivision_into_blocks(graph));
  layout.provenance = graph.provenance;
  return layout;
}

}  // namespace quadrille::block
