#include "block/block_maps.hpp"

#include "mesh/chords.hpp"

namespace quadrille::block {

BlockMaps::BlockMaps(const BlockLayout& layout)
    : layout_(&layout), table_(layout.face, layout.splines), chains_(layout.arcs.size()) {}

const curve::Chain& BlockMaps::arc(int a) const {
  std::optional<curve::Chain>& chain = chains_[a];
  if (!chain) chain.emplace(table_, layout_->arcs[a].pieces);
  return *chain;
}

mesh::TransfiniteMap BlockMaps::map(int block) const {
  std::array<const curve::Chain*, 4> sides{};
  std::array<bool, 4> backwards{};
  for (int k = 0; k < 4; ++k) {
    const HalfEdge directed = layout_->block2arcs[block][k];
    sides[k] = &arc(directed.arc);
    backwards[k] = directed.is_backwards;
  }
  return mesh::TransfiniteMap(sides, backwards);
}

}  // namespace quadrille::block
