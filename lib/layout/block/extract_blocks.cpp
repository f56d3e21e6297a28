#include "block/extract_blocks.hpp"

#include <fmt/format.h>

#include "base/assign_names.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "graph/face_corners.hpp"
#include "mesh/chords.hpp"
#include "model/interfaces.hpp"

namespace quadrille::block {
namespace {

void require_conforming(const SeparatrixGraph& graph) {
  if (graph.t_junctions.empty()) return;
  const Vec2 position = graph.nodes[graph.t_junctions.front()].position + graph.face.origin;
  throw ComputeError(
      fmt::format("a separatrix ends on the side of a block at {}; blocks must conform", position_text(position)));
}

/// The region of each block: blocks beside each other are of one region if no interface lies between them, and every
/// region has a block along one of its curves.
std::vector<int> regions_of_blocks(const BlockLayout& layout) {
  const std::vector<int> curve_region = curve_regions(layout.face);
  DisjointSets connected(layout.num_blocks());
  std::vector<int> first_block(layout.arcs.size(), -1), known(layout.num_blocks(), 0);
  for (int b = 0; b < layout.num_blocks(); ++b)
    for (const HalfEdge side : layout.block2arcs[b]) {
      int& first = first_block[side.arc];
      if (first >= 0 && !is_on_interface(layout, layout.arcs[side.arc])) connected.unite(first, b);
      first = first < 0 ? b : first;
    }
  for (int b = 0; b < layout.num_blocks(); ++b)
    for (const HalfEdge side : layout.block2arcs[b]) {
      const int region = region_on_left(layout, side, curve_region);
      if (region >= 0) known[connected.find(b)] = region;
    }
  std::vector<int> regions;
  for (int b = 0; b < layout.num_blocks(); ++b) regions.push_back(known[connected.find(b)]);
  return regions;
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
  layout.arc_chord = mesh::arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()), matched_arcs(layout));
  if (layout.face.num_regions() > 1) layout.block_region = regions_of_blocks(layout);
  return layout;
}

BlockLayout extract_blocks(const SeparatrixGraph& graph) {
  BlockLayout layout = blocks_of(subdivision_into_blocks(graph));
  layout.provenance = graph.provenance;
  return layout;
}

}  // namespace quadrille::block
