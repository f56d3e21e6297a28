#include "block/block_maps.hpp"

#include "mesh/chords.hpp"

namespace quadrille::block {

BlockMaps::BlockMaps(const BlockLayout& layout) : layout_(&layout), table_(layout.face, layout.splines) {
  chains_.reserve(layout.arcs.size());
  for (const GraphArc& arc : layout.arcs) chains_.emplace_back(table_, arc.pieces);
}

mesh::TransfiniteMap BlockMaps::map(int block) const {
  std::array<const curve::Chain*, 4> sides{};
  std::array<bool, 4> backwards{};
  for (int k = 0; k < 4; ++k) {
    const HalfEdge directed = layout_->block2arcs[block][k];
    sides[k] = &chains_[directed.arc];
    backwards[k] = directed.is_backwards;
  }
  return mesh::TransfiniteMap(sides, backwards);
}

}  // namespace quadrille::block
