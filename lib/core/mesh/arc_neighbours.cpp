#include "mesh/arc_neighbours.hpp"

#include "model/interfaces.hpp"

namespace quadrille::mesh {

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
