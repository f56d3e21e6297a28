#include "block/extract_blocks.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "graph/planar_faces.hpp"
#include "mesh/chords.hpp"

namespace quadrille::block {
namespace {

void require_conforming(const SeparatrixGraph& graph) {
  if (graph.t_junctions.empty()) return;
  const Vec2 place = graph.nodes[graph.t_junctions.front()].position + graph.face.origin;
  throw ComputeError(fmt::format("a separatrix ends on the side of a block at ({:.6g}, {:.6g}); blocks must conform",
                                 place.x, place.y));
}

}  // namespace

BlockLayout extract_blocks(const SeparatrixGraph& graph) {
  require_conforming(graph);
  if (graph::require_four_corners(graph) == 0) throw ComputeError("the graph has no faces");
  BlockLayout layout;
  layout.provenance = graph.provenance;
  layout.face = graph.face;
  layout.splines = graph.splines;
  layout.nodes = graph.nodes;
  layout.arcs = graph.arcs;

  for (const std::vector<HalfEdge>& cycle : graph::planar_faces(graph).cycles) {
    std::array<HalfEdge, 4> arcs;
    std::array<int, 4> nodes{};
    for (int k = 0; k < 4; ++k) arcs[k] = cycle[k], nodes[k] = start_of(graph.arcs, cycle[k]);
    layout.block2arcs.push_back(arcs);
    layout.block2nodes.push_back(nodes);
    layout.block_names.push_back(fmt::format("block_{}", layout.num_blocks() - 1));
  }
  layout.arc_chord = mesh::arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()));
  return layout;
}

}  // namespace quadrille::block
