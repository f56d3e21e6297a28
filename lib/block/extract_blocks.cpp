#include "block/extract_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "block/graph_faces.hpp"
#include "curve/chain.hpp"
#include "mesh/chords.hpp"
#include "mesh/transfinite.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"

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

/// Mean of the middles of the sides: a place to look at, also where the face is not convex.
Vec2 middle_of(const std::vector<int>& face, const std::vector<Chain>& chains) {
  Vec2 sum;
  for (const int directed : face) sum += chains[arc_of(directed)].at(0.5).position;
  return sum / static_cast<double>(face.size());
}

/// Twice the area inside the cycle, from a polygon: only its sign is of interest.
double signed_area(const std::vector<int>& face, const std::vector<Chain>& chains) {
  constexpr int samples = 16;
  std::vector<Vec2> polygon;
  for (const int directed : face)
    for (int k = 0; k < samples; ++k) {
      const double f = static_cast<double>(k) / samples;
      polygon.push_back(chains[arc_of(directed)].at(is_backwards(directed) ? 1 - f : f).position);
    }
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sum += cross(polygon[k] - polygon[0], polygon[(k + 1) % polygon.size()] - polygon[0]);
  return sum;
}

void require_four_sides(const std::vector<int>& face, const SeparatrixGraph& graph, const std::vector<Chain>& chains) {
  const Vec2 place = middle_of(face, chains) + graph.face.origin;
  if (signed_area(face, chains) <= 0)
    throw ComputeError(
        fmt::format("no separatrix reaches the hole around ({:.6g}, {:.6g}): the face around it has no four sides",
                    place.x, place.y));
  if (face.size() != 4)
    throw ComputeError(fmt::format("the face around ({:.6g}, {:.6g}) has {} corner{} where a block needs 4", place.x,
                                   place.y, face.size(), face.size() == 1 ? "" : "s"));
}

int start_of(const SeparatrixGraph& graph, int directed) {
  const GraphArc& arc = graph.arcs[arc_of(directed)];
  return is_backwards(directed) ? arc.to : arc.from;
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
  BlockLayout layout;
  layout.provenance = graph.provenance;
  layout.face = graph.face;
  layout.splines = graph.splines;
  layout.nodes = graph.nodes;
  layout.arcs = graph.arcs;

  const CurveTable table(layout.face, layout.splines);
  std::vector<Chain> chains;
  for (const GraphArc& arc : layout.arcs) chains.emplace_back(table, arc.pieces);
  for (const std::vector<int>& face : graph_faces(graph)) {
    require_four_sides(face, graph, chains);
    std::array<int, 4> arcs{}, nodes{};
    for (int k = 0; k < 4; ++k) arcs[k] = face[k], nodes[k] = start_of(graph, face[k]);
    layout.block2arcs.push_back(arcs);
    layout.block2nodes.push_back(nodes);
    layout.block_names.push_back(fmt::format("block_{}", layout.num_blocks() - 1));
  }
  if (layout.num_blocks() == 0) throw ComputeError("the graph has no faces");
  layout.arc_chord = arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()));
  for (int b = 0; b < layout.num_blocks(); ++b)
    layout.block_jacobian_bound.push_back(jacobian_bound(layout, chains, b));
  tell(layout, report);
  return layout;
}

}  // namespace quadrille
