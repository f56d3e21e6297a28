#include "layers/arc_neighbours.hpp"

#include <array>

#include "mesh/chords.hpp"

namespace quadrille::layers {
namespace {

ArcEnd beginning(HalfEdge directed) { return {directed.arc, directed.is_backwards ? 1 : 0}; }
ArcEnd end(HalfEdge directed) { return {directed.arc, directed.is_backwards ? 0 : 1}; }

}  // namespace

std::vector<ArcNeighbours> arc_neighbours(const BlockLayout& layout) {
  std::vector<std::vector<std::array<int, 2>>> arc2sides(layout.arcs.size());
  for (int block = 0; block < layout.num_blocks(); ++block)
    for (int side = 0; side < 4; ++side) arc2sides[layout.block2arcs[block][side].arc].push_back({block, side});
  std::vector<ArcNeighbours> pairs;
  for (const std::vector<std::array<int, 2>>& sides : arc2sides) {
    if (sides.size() != 2 || sides[0][0] == sides[1][0]) continue;
    const auto directed = [&](int which, int step) {
      return layout.block2arcs[sides[which][0]][(sides[which][1] + step + 4) % 4];
    };
    pairs.push_back({end(directed(0, -1)), beginning(directed(1, 1))});
    pairs.push_back({beginning(directed(0, 1)), end(directed(1, -1))});
  }
  return pairs;
}

}  // namespace quadrille::layers
