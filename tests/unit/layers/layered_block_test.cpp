#include "layers/layered_block.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

/// The unit square with the same divisions on opposite sides; walls are added by the tests.
class Square {
 public:
  Square(const std::vector<double>& s, const std::vector<double>& t) {
    for (int k = 0; k < 4; ++k) {
      const curve::Chain chain(table, {{k, 0, 1}});
      block.tables[k] = SideTable(chain, k >= 2);
      block.fractions[k] = k % 2 == 0 ? s : t;
      block.lengths[k] = 1;
      lines[k] = WallLine(table, {{k, 0, 1}});
    }
  }

  void add_wall(int side, std::vector<double> heights) {
    block.sides[side] = {&lines[side], std::move(heights), {}};
    for (const double f : block.fractions[side]) block.sides[side].feet.push_back({0, side >= 2 ? 1 - f : f});
  }

  const CadFace face = hand_made::unit_square().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table{face, none};
  std::array<WallLine, 4> lines;
  LayeredBlock block;
};

TEST(LayeredBlock, WithoutWallsNodesLieWhereStraightLinesCross) {
  Square square({0, 0.3, 1}, {0, 0.6, 1});
  square.block.fractions[2] = {0, 0.5, 1};
  const Vec2 node = layered_positions(square.block, 1, {})[4];
  EXPECT_NEAR(node.x, 0.3 + 0.2 * 0.6, 1e-12);
  EXPECT_NEAR(node.y, 0.6, 1e-12);
}

// Every wall alone, then all pairs, which meet in a corner or face each other (rules 8 and 14 of layer_rules).
TEST(LayeredBlock, NodesOfEveryWallLieAtItsHeightsAlsoBesideOtherWalls) {
  const std::vector<double> heights{0.1, 0.25};
  const std::vector<double> divided{0, 0.1, 0.25, 0.5, 0.75, 0.9, 1};
  for (int first = 0; first < 4; ++first)
    for (int second = first; second < 4; ++second) {
      Square square(divided, divided);
      square.add_wall(first, heights);
      if (second != first) square.add_wall(second, heights);
      const std::vector<Vec2> nodes = layered_positions(square.block, 1, {});
      for (int j = 1; j < 6; ++j)
        for (int i = 1; i < 6; ++i) {
          const Vec2 x = nodes[j * 7 + i];
          for (const int side : {first, second}) {
            const int layer = side == 0 ? j : side == 1 ? 6 - i : side == 2 ? 6 - j : i;
            const double height = side == 0 ? x.y : side == 1 ? 1 - x.x : side == 2 ? 1 - x.y : x.x;
            if (layer > 2) continue;
            EXPECT_NEAR(height, heights[layer - 1], 1e-9) << first << second << " " << i << j;
          }
        }
    }
}

}  // namespace
}  // namespace quadrille::layers
