#include "layers/layered_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

/// Interior lines, each with the given lengths of its intervals.
std::vector<std::vector<double>> equal_lines(std::size_t count, const std::vector<double>& lengths) {
  std::vector<std::vector<double>> lines(count, lengths);
  lines.front().clear(), lines.back().clear();
  return lines;
}

// The layers are 0.1 high in a block that is from 0.5 to 1 wide: on every line at another part of it. The nodes above
// are those prescribed for the line, although lines lie much closer together than their nodes.
TEST(LayeredBlock, LinesCloseTogetherKeepTheirDivisionAboveLayersAtDifferentParts) {
  std::vector<double> across;
  for (int k = 0; k <= 40; ++k) across.push_back(k / 40.0);
  Square square(across, {0, 0.1, 0.4, 0.7, 1});
  const CadFace trapezium = hand_made::face({{curve::segment({0, 0}, {0.1, 0}), curve::segment({0.1, 0}, {0.1, 1}),
                                              curve::segment({0.1, 1}, {0, 0.5}), curve::segment({0, 0.5}, {0, 0})}},
                                            1);
  const std::vector<Nurbs> none;
  const curve::CurveTable table{trapezium, none};
  for (int k = 0; k < 4; ++k) square.block.tables[k] = SideTable(curve::Chain(table, {{k, 0, 1}}), k >= 2);
  square.block.lengths = {0.1, 1, std::hypot(0.1, 0.5), 0.5};
  square.block.fractions[3] = {0, 0.2, 0.2 + 0.8 / 3, 0.2 + 1.6 / 3, 1};
  square.lines[0] = WallLine(table, {{0, 0, 1}});
  square.add_wall(0, {0.1});
  square.block.lines[0] = equal_lines(41, {1, 1, 1});
  const std::vector<Vec2> nodes = layered_positions(square.block, 1, {});
  for (int i = 1; i < 40; ++i) {
    const double top = 0.5 + i / 80.0, low = nodes[41 + i].y;
    EXPECT_NEAR(low, 0.1, 1e-3);
    for (const int j : {2, 3}) EXPECT_NEAR(nodes[j * 41 + i].y, low + (j - 1) * (top - low) / 3, 1e-6) << i;
  }
}

// Rows and columns are given, and the sides of the block are divided otherwise.
TEST(LayeredBlock, WithoutWallsRowsAndColumnsMayBeExchanged) {
  const std::vector<double> fine{0, 0.02, 0.5, 1}, coarse{0, 0.3, 0.6, 1};
  const std::vector<std::vector<double>> of_fine = equal_lines(4, {0.1, 0.4, 0.5}),
                                         of_coarse = equal_lines(4, {0.5, 0.2, 0.3});
  Square square(fine, coarse), exchanged(coarse, fine);
  square.block.lines = {of_coarse, of_fine};
  exchanged.block.lines = {of_fine, of_coarse};
  const std::vector<Vec2> nodes = layered_positions(square.block, 1, {});
  const std::vector<Vec2> others = layered_positions(exchanged.block, 1, {});
  for (const int j : {1, 2})
    for (const int i : {1, 2}) {
      EXPECT_NEAR(nodes[j * 4 + i].x, others[i * 4 + j].y, 1e-12);
      EXPECT_NEAR(nodes[j * 4 + i].y, others[i * 4 + j].x, 1e-12);
    }
}

// The two opposite sides of each direction are divided otherwise, in the same way in both directions.
TEST(LayeredBlock, WithoutWallsEquallyDividedSidesGiveNodesThatAreTheirMirrorImages) {
  const std::vector<double> near{0, 0.1, 0.4, 1}, far{0, 0.3, 0.7, 1};
  Square square(near, near);
  square.block.fractions[1] = square.block.fractions[2] = far;
  square.block.lines[0] = square.block.lines[1] = equal_lines(4, {0.2, 0.3, 0.5});
  const std::vector<Vec2> nodes = layered_positions(square.block, 1, {});
  for (const int j : {1, 2})
    for (const int i : {1, 2}) {
      EXPECT_NEAR(nodes[j * 4 + i].x, nodes[i * 4 + j].y, 1e-12);
      EXPECT_NEAR(nodes[j * 4 + i].y, nodes[i * 4 + j].x, 1e-12);
    }
}

TEST(LayeredBlock, LinesMayBeGivenInOneDirectionAlone) {
  Square square({0, 0.5, 1}, {0, 0.5, 1});
  square.block.lines[1] = {{}, {1, 3}, {}};
  const Vec2 node = layered_positions(square.block, 1, {})[4];
  EXPECT_LT(node.x, 0.48);
  EXPECT_NEAR(node.y, 0.5, 1e-12);
}

// A square with two bulging sides, and its upper half: nodes on the line of symmetry are those of the whole there.
TEST(LayeredBlock, NodesOfAHalfAreThoseOfTheWhole) {
  const Nurbs top = curve::circular_arc({1, 0}, std::sqrt(2), pi / 4, 3 * pi / 4);
  const CadFace face = hand_made::face(
      {{curve::segment({0, 0}, {2, 0}), curve::segment({2, 0}, {2, 1}), top, curve::segment({0, 1}, {0, 0})}}, 3);
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const double u = 0.3, x = 1 - std::sqrt(2) * std::cos(pi / 4 + u * half_pi);
  for (const bool is_transposed : {false, true}) {
    LayeredBlock block;
    const int line = is_transposed ? 3 : 0;
    for (int k = 0; k < 4; ++k) {
      const int curve = is_transposed ? 3 - k : k;
      const curve::Chain chain(table, {{curve, face.curves[curve].begin(), face.curves[curve].end()}});
      block.tables[k] = SideTable(chain, curve >= 2);
      block.lengths[k] = chain.length();
      block.fractions[k] = {0, k == line ? x / 2 : (k + 2) % 4 == line ? u : 0.5, 1};
    }
    block.halved = sizing::HalvedSide{line, {{0, 0}, {1, 0}, {0}}};
    const Vec2 node = layered_positions(block, 1, {})[4];
    EXPECT_NEAR(node.x, x, 1e-10);
    EXPECT_NEAR(node.y, 0.5 * (std::sqrt(2) * std::sin(pi / 4 + u * half_pi)), 1e-10);
  }
}

// The shifts are given for the block with the lines along the wall's normals as columns.
TEST(LayeredBlock, ShiftedLinesKeepTheHeightsOfLayers) {
  const std::vector<double> divided{0, 0.1, 0.25, 0.5, 0.75, 0.9, 1}, heights{0.1, 0.25};
  for (const int wall : {0, 1, 2, 3}) {
    Square square(divided, divided);
    square.add_wall(wall, heights);
    square.block.shifts.assign(7, std::vector<double>(7, 0));
    for (int row = 1; row < 6; ++row) square.block.shifts[row][3] = 0.4;
    const std::vector<Vec2> nodes = layered_positions(square.block, 1, {});
    for (int k = 1; k < 6; ++k) {
      const bool is_column = wall % 2 == 0;
      const Vec2 x = nodes[is_column ? k * 7 + 3 : 3 * 7 + k];
      EXPECT_NEAR(is_column ? x.y : x.x, divided[k], 1e-9) << wall << " " << k;
      EXPECT_GT(is_column ? x.x : x.y, 0.59) << wall << " " << k;
    }
  }
}

// Lines far apart, compared to their nodes, are not tied to each other.
TEST(LayeredBlock, FactorsScaleTheIntervalsOfALineUpToACommonFactor) {
  Square square({0, 0.5, 1}, {0, 0.01, 0.02, 0.03, 1});
  square.block.lines[0] = {{}, {0.01, 0.01, 0.01, 0.97}, {}};
  square.block.factors[0] = {{}, {1, 3, 1, 1}, {}};
  const std::vector<Vec2> nodes = layered_positions(square.block, 1, {});
  EXPECT_NEAR(nodes[4].y, 0.01 / 1.02, 1e-4);
  EXPECT_NEAR(nodes[7].y, 0.04 / 1.02, 1e-4);
}

TEST(LayeredBlock, FactorsOfALineBesideAnotherAreTiedToIt) {
  Square square({0, 1e-6, 1}, {0, 0.5, 1});
  square.block.lines[0] = {{}, {1, 1}, {}};
  square.block.factors[0] = {{}, {3, 1}, {}};
  EXPECT_NEAR(layered_positions(square.block, 1, {})[4].y, 0.5, 1e-4);
}

}  // namespace
}  // namespace quadrille::layers
