#include "mesh/block_sides.hpp"

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

}  // namespace quadrille::mesh
