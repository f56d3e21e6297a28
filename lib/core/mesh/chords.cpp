#include "mesh/chords.hpp"

#include <algorithm>

#include "base/disjoint_sets.hpp"
#include "model/interfaces.hpp"

namespace quadrille::mesh {

HalfEdge half_edge(const BlockLayout& layout, int block, int side) { return layout.block2arcs[block][(side + 4) % 4]; }

ArcSides sides_of_arcs(const BlockLayout& layout) {
  ArcSides arc_sides(layout.arcs.size());
  for (int block = 0; block < layout.num_blocks(); ++block)
    for (int side = 0; side < 4; ++side) arc_sides[half_edge(layout, block, side).arc].push_back({block, side});
  return arc_sides;
}

BlockSide next_along_boundary(const BlockLayout& layout, const ArcSides& arc_sides, const BlockSide& side, int step) {
  const HalfEdge between = half_edge(layout, side.block, side.side + step);
  if (is_on_interface(layout, layout.arcs[half_edge(layout, side.block, side.side).arc]) &&
      is_on_interface(layout, layout.arcs[between.arc]))
    return {};
  for (const BlockSide& other : arc_sides[between.arc]) {
    if (half_edge(layout, other.block, other.side) == between) continue;  // the other block is this block itself
    const int next = (other.side + step + 4) % 4;
    const GraphArc& own_arc = layout.arcs[half_edge(layout, side.block, side.side).arc];
    const GraphArc& next_arc = layout.arcs[half_edge(layout, other.block, next).arc];
    const bool is_between_regions = is_on_interface(layout, own_arc);
    if (is_between_regions ? is_on_interface(layout, next_arc) : next_arc.is_boundary) return {other.block, next};
  }
  return {};
}

ArcEnd beginning(HalfEdge half_edge) { return {half_edge.arc, half_edge.is_backwards ? 1 : 0}; }
ArcEnd ending(HalfEdge half_edge) { return {half_edge.arc, half_edge.is_backwards ? 0 : 1}; }

std::vector<ArcNeighbours> arc_neighbours(const BlockLayout& layout) {
  std::vector<ArcNeighbours> pairs;
  const ArcSides arc_sides = sides_of_arcs(layout);
  const std::vector<int> curve_region = curve_regions(layout.face);
  for (std::size_t a = 0; a < arc_sides.size(); ++a) {
    const std::vector<BlockSide>& sides = arc_sides[a];
    if (sides.size() != 2 || sides[0].block == sides[1].block) continue;
    if (separates_faces(layout, layout.arcs[a], curve_region)) continue;
    const auto beside = [&](int which, int step) {
      return half_edge(layout, sides[which].block, sides[which].side + step);
    };
    pairs.push_back({ending(beside(0, -1)), beginning(beside(1, 1))});
    pairs.push_back({beginning(beside(0, 1)), ending(beside(1, -1))});
  }
  return pairs;
}

std::vector<int> arc_chords(const std::vector<std::array<HalfEdge, 4>>& block2arcs, int num_arcs,
                            const std::vector<PeriodicArcs>& periodic) {
  DisjointSets linked(num_arcs);
  for (const auto& [first, second] : periodic) linked.unite(first.arc, second.arc);
  for (const std::array<HalfEdge, 4>& arcs : block2arcs)
    for (int k = 0; k < 2; ++k) linked.unite(arcs[k].arc, arcs[k + 2].arc);
  std::vector<int> chord(num_arcs);
  int num_chords = 0;
  for (int arc = 0; arc < num_arcs; ++arc) {
    const int lowest = linked.find(arc);
    chord[arc] = lowest == arc ? num_chords++ : chord[lowest];
  }
  return chord;
}

std::vector<Chord> directed_chords(const std::vector<std::array<HalfEdge, 4>>& block2arcs,
                                   const std::vector<int>& arc_chord, const std::vector<PeriodicArcs>& periodic) {
  const int num_arcs = static_cast<int>(arc_chord.size());
  struct Link {
    int arc;
    bool flips;  ///< opposite sides, each taken counter-clockwise, have opposite directions
  };
  std::vector<std::vector<Link>> links(num_arcs);
  const auto connect = [&](HalfEdge a, HalfEdge b) {
    const bool flips = a.is_backwards == b.is_backwards;
    links[a.arc].push_back({b.arc, flips});
    links[b.arc].push_back({a.arc, flips});
  };
  for (const std::array<HalfEdge, 4>& sides : block2arcs)
    for (int k = 0; k < 2; ++k) connect(sides[k], sides[k + 2]);
  for (const auto& [first, second] : periodic) connect(first, second);
  std::vector<Chord> chords(num_arcs == 0 ? 0 : 1 + *std::max_element(arc_chord.begin(), arc_chord.end()));
  std::vector<int> arc2index(num_arcs, -1);
  for (int first = 0; first < num_arcs; ++first) {
    if (arc2index[first] >= 0) continue;
    Chord& chord = chords[arc_chord[first]];
    const auto add = [&](int arc, bool backwards) {
      arc2index[arc] = static_cast<int>(chord.arcs.size());
      chord.arcs.push_back(arc);
      chord.backwards.push_back(backwards);
    };
    add(first, false);
    for (std::size_t k = 0; k < chord.arcs.size(); ++k)
      for (const Link& link : links[chord.arcs[k]])
        if (arc2index[link.arc] < 0) add(link.arc, chord.backwards[k] != link.flips);
  }
  for (const std::array<HalfEdge, 4>& sides : block2arcs)
    for (int k = 0; k < 2; ++k) {
      const int a = sides[k].arc, b = sides[k + 2].arc;
      if (a != b) chords[arc_chord[a]].pairs.push_back({arc2index[a], arc2index[b]});
    }
  return chords;
}

}  // namespace quadrille::mesh
