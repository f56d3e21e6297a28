#include "mesh/arc_neighbours.hpp"

namespace quadrille::mesh {

std::vector<ArcNeighbours> arc_neighbours(const BlockLayout& layout) {
  std::vector<ArcNeighbours> pairs;
  for (const std::vector<BlockSide>& sides : sides_of_arcs(layout)) {
    if (sides.size() != 2 || sides[0].block == sides[1].block) continue;
    const auto beside = [&](int which, int step) {
      return half_edge(layout, sides[which].block, sides[which].side + step);
    };
    pairs.push_back({ending(beside(0, -1)), beginning(beside(1, 1))});
    pairs.push_back({beginning(beside(0, 1)), ending(beside(1, -1))});
  }
  return pairs;
}

}  // namespace quadrille::mesh
