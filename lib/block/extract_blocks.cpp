#include "block/extract_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "curve/chain.hpp"
#include "mesh/chords.hpp"
#include "mesh/transfinite.hpp"
#include "spectral/quad_map.hpp"
#include "trace/planar_faces.hpp"

namespace quadrille {
namespace {

/// A block is judged as one quad of this order.
constexpr int block_order = 8;

void require_conforming(const SeparatrixGraph& graph) {
  if (graph.t_junctions.empty()) return;
  const Vec2 place = graph.nodes[graph.t_junctions.front()].position + graph.face.origin;
  throw ComputeError(fmt::format("a separatrix ends on the side of a block at ({:.6g}, {:.6g}); blocks must conform",
                                 place.x, place.y));
}

double jacobian_bound(const BlockLayout& layout, const std::vector<Chain>& chains, int block) {
  std::array<const Chain*, 4> sides{};
  std::array<bool, 4> backwards{};
  for (int k = 0; k < 4; ++k) {
    const int directed = layout.block2arcs[block][k];
    sides[k] = &chains[arc_of(directed)];
    backwards[k] = is_backwards(directed);
  }
  return quad_jacobian_lower_bound(block_order, TransfiniteMap(sides, backwards).sampled(block_order).data());
}

void tell(const BlockLayout& layout, Report& report) {
  const std::vector<double>& bounds = layout.block_jacobian_bound;
  report.set("blocks", layout.num_blocks());
  report.set("arcs", layout.arcs.size());
  report.set("chords",
             layout.arc_chord.empty() ? 0 : 1 + *std::max_element(layout.arc_chord.begin(), layout.arc_chord.end()));
  report.set("irregular_nodes",
             static_cast<int>(std::count_if(layout.nodes.begin(), layout.nodes.end(),
                                            [](const GraphNode& n) { return n.curve < 0 && n.valence != 4; })));
  if (!bounds.empty()) report.set("least_jacobian_bound", *std::min_element(bounds.begin(), bounds.end()));
}

}  // namespace

BlockLayout extract_blocks(const SeparatrixGraph& graph, Report& report) {
  require_conforming(graph);
  if (require_four_corners(graph) == 0) throw ComputeError("the graph has no faces");
  BlockLayout layout;
  layout.provenance = graph.provenance;
  layout.face = graph.face;
  layout.splines = graph.splines;
  layout.nodes = graph.nodes;
  layout.arcs = graph.arcs;

  const CurveTable table(layout.face, layout.splines);
  std::vector<Chain> chains;
  for (const GraphArc& arc : layout.arcs) chains.emplace_back(table, arc.pieces);
  for (const std::vector<int>& cycle : planar_faces(graph).cycles) {
    std::array<int, 4> arcs{}, nodes{};
    for (int k = 0; k < 4; ++k) arcs[k] = cycle[k], nodes[k] = dart_from(graph, cycle[k]);
    layout.block2arcs.push_back(arcs);
    layout.block2nodes.push_back(nodes);
    layout.block_names.push_back(fmt::format("block_{}", layout.num_blocks() - 1));
  }
  layout.arc_chord = arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()));
  for (int b = 0; b < layout.num_blocks(); ++b)
    layout.block_jacobian_bound.push_back(jacobian_bound(layout, chains, b));
  tell(layout, report);
  return layout;
}

}  // namespace quadrille
