#include "block/extract_blocks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "graph/candidate_layout.hpp"
#include "mesh/chords.hpp"
#include "mesh/given_position.hpp"
#include "model/interfaces.hpp"
#include "surface/positions.hpp"

namespace quadrille::block {
namespace {

void require_conforming(const SeparatrixGraph& graph) {
  if (graph.t_junctions.empty()) return;
  throw ComputeError(fmt::format("a separatrix ends on the side of a block at {}; blocks must conform",
                                 surface::position_text(graph.face, graph.nodes[graph.t_junctions.front()].position)));
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

/// The angle that the curve sweeps about x, 2 pi for one counter-clockwise turn. A curve lies in the hull of its poles:
/// if these lie within a quarter turn of the first, the angle follows from the ends; else the curve is halved.
double swept_angle(const Nurbs& curve, Vec2 x, int depth = 0) {
  const Vec2 first = curve.poles.front() - x, last = curve.poles.back() - x;
  const auto is_near_first = [&](Vec2 pole) { return dot(first, pole - x) > 0; };
  if (depth == 50 || std::all_of(curve.poles.begin(), curve.poles.end(), is_near_first))
    return std::atan2(cross(first, last), dot(first, last));
  const double middle = 0.5 * (curve.begin() + curve.end());
  return swept_angle(curve::trimmed(curve, curve.begin(), middle), x, depth + 1) +
         swept_angle(curve::trimmed(curve, middle, curve.end()), x, depth + 1);
}

/// The angle that each arc sweeps about x, from its first node to its last.
std::vector<double> swept_angles(const BlockLayout& layout, Vec2 x) {
  std::vector<double> angles;
  for (const GraphArc& arc : layout.arcs) {
    double angle = 0;
    for (const ArcPiece& piece : arc.pieces) {
      const auto [low, high] = std::minmax(piece.t0, piece.t1);
      const double swept = swept_angle(curve::trimmed(layout.curve(piece.curve), low, high), x);
      angle += piece.t0 < piece.t1 ? swept : -swept;
    }
    angles.push_back(angle);
  }
  return angles;
}

/// The blocks beside an arc on which x lies.
std::vector<int> blocks_that_touch(const BlockLayout& layout, Vec2 x) {
  std::vector<bool> is_near(layout.arcs.size(), false);
  for (std::size_t a = 0; a < layout.arcs.size(); ++a)
    for (const ArcPiece& piece : layout.arcs[a].pieces) {
      const auto [low, high] = std::minmax(piece.t0, piece.t1);
      const double distance = curve::project(layout.curve(piece.curve), x, low, high).distance;
      is_near[a] = is_near[a] || distance <= 1e-6 * layout.face.diameter;
    }
  std::vector<int> blocks;
  for (int b = 0; b < layout.num_blocks(); ++b) {
    const auto& arcs = layout.block2arcs[b];
    if (std::any_of(arcs.begin(), arcs.end(), [&](HalfEdge h) { return is_near[h.arc]; })) blocks.push_back(b);
  }
  return blocks;
}

int block_at(const BlockLayout& layout, const NameRule& rule) {
  const Vec2 x = mesh::given_position(layout.face, rule.position, rule.where);
  const std::string text = fmt::format("({:.6g})", fmt::join(rule.position, ", "));
  if (const std::vector<int> touching = blocks_that_touch(layout, x); !touching.empty())
    throw FormatError(fmt::format("{}: {} lies on a side of block {}, not inside a block", rule.where, text,
                                  fmt::join(touching, " and of block ")));
  const std::vector<double> angles = swept_angles(layout, x);
  for (int b = 0; b < layout.num_blocks(); ++b) {
    double angle = 0;
    for (const HalfEdge h : layout.block2arcs[b]) angle += h.is_backwards ? -angles[h.arc] : angles[h.arc];
    if (angle > pi) return b;
  }
  throw FormatError(fmt::format("{}: {} lies in no block", rule.where, text));
}

int block_of(const BlockLayout& layout, const NameRule& rule) {
  if (rule.kind == NameRule::Kind::position) return block_at(layout, rule);
  if (rule.number < 0 || rule.number >= layout.num_blocks())
    throw FormatError(
        fmt::format("{}: no block has this number; blocks are numbered 0 to {}", rule.where, layout.num_blocks() - 1));
  return rule.number;
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

void name_blocks(BlockLayout& layout, const std::vector<NameRule>& rules) {
  if (layout.face.num_regions() > 1) {
    for (int b = 0; b < layout.num_blocks(); ++b)
      layout.block_names[b] = layout.face.region_names[layout.block_region[b]];
    layout.unnamed_blocks.clear();
  } else if (!layout.face.name.empty()) {
    layout.block_names.assign(layout.num_blocks(), layout.face.name);
    layout.unnamed_blocks.clear();
  }
  std::vector<int> all_blocks(layout.num_blocks());
  std::iota(all_blocks.begin(), all_blocks.end(), 0);
  std::vector<GivenName> given;
  for (const NameRule& rule : rules) {
    const bool is_for_rest = rule.kind == NameRule::Kind::rest;
    given.push_back(
        {rule.name, is_for_rest ? all_blocks : std::vector<int>{block_of(layout, rule)}, is_for_rest, rule.where});
  }
  const std::vector<int> named = assign_names(layout.block_names, given, "block");
  std::erase_if(layout.unnamed_blocks, [&](int b) { return std::binary_search(named.begin(), named.end(), b); });
}

}  // namespace quadrille::block
