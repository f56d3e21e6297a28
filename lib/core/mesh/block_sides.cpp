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

}  // namespace quadrille::mesh
