#include "growth/line_intervals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "../layers/wall_samples.hpp"
#include "refine/split_isoparametric.hpp"

namespace quadrille::growth {
namespace {

using wall_samples::PlannedWalls;
constexpr double limit = 1.3;
constexpr int order = 2;

/// Layers along the lower sides of two unit squares.
PlannedWalls layered_row() {
  return PlannedWalls(hand_made::row({1, 1}), 0.2,
                      {"side_0:first=0.02,growth=1.2,layers=3", "side_1:first=0.02,growth=1.2,layers=3"}, order);
}

QuadMesh mesh_of(const PlannedWalls& p, const LinePlan& lines) {
  return refine::split_isoparametric(p.measured, p.divisions, order, &p.plan, lines);
}

/// Elements of order 2 whose node (i, j) lies at (i, 10 j).
TEST(BlockVertices, AreEveryOtherNodeOfElementsOfOrderTwo) {
  constexpr int columns = 3, rows = 2, width = 2 * columns + 1;
  QuadMesh mesh;
  mesh.order = 2;
  mesh.elem_nodes.assign(9, 0);  // of another block
  for (int j = 0; j <= 2 * rows; ++j)
    for (int i = 0; i < width; ++i) mesh.nodes.push_back({1.0 * i, 10.0 * j});
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      for (int k = 0; k < 9; ++k) mesh.elem_nodes.push_back((2 * row + k / 3) * width + 2 * column + k % 3);
  const BlockVertices block(mesh, 1, columns, rows);
  for (int node = 0; node < width; ++node)
    for (int k = 0; k <= rows; ++k) EXPECT_EQ(block.at(0, node, k), (Vec2{1.0 * node, 20.0 * k}));
  for (int node = 0; node <= 2 * rows; ++node)
    for (int k = 0; k <= columns; ++k) EXPECT_EQ(block.at(1, node, k), (Vec2{2.0 * k, 10.0 * node}));
}

TEST(BlockVertices, BlocksFollowEachOther) {
  const PlannedWalls p = layered_row();
  const QuadMesh mesh = mesh_of(p, {});
  const std::vector<BlockVertices> blocks = block_vertices(p.layout, p.divisions, mesh);
  ASSERT_EQ(blocks.size(), 2u);
  for (int block = 0; block < 2; ++block)
    for (const int corner : {0, 1, 2, 3}) {
      const BlockVertices& own = blocks[block];
      const int node = corner == 1 || corner == 2 ? own.columns() * order : 0, k = corner < 2 ? 0 : own.rows();
      const Vec2 expected = p.layout.nodes[p.layout.block2nodes[block][corner]].position;
      EXPECT_LT(distance(own.at(0, node, k), expected), 1e-14) << block << ' ' << corner;
    }
}

/// In rectangles whose opposite sides have equal intervals, lines have those of the sides.
TEST(LineIntervals, OfRectanglesAreThoseOfTheSides) {
  const PlannedWalls p = layered_row();
  const BlockLines lines = line_intervals(p.measured, p.plan, p.divisions, limit, order);
  ASSERT_EQ(lines.size(), 2u);
  for (int block = 0; block < 2; ++block)
    for (const int direction : {0, 1}) {
      const sizing::ArcDivision& side = p.divisions[p.layout.block2arcs[block][direction == 0 ? 1 : 0].arc];
      const auto [before, after] = p.plan.num_fixed_along(block, direction);
      const double total = direction == 0 ? 1 - p.plan.heights[0].back() : 1;
      const auto& of = lines[block][direction];
      EXPECT_TRUE(of.front().empty() && of.back().empty()) << "they lie on the sides";
      for (std::size_t node = 1; node + 1 < of.size(); ++node) {
        EXPECT_EQ(std::ssize(of[node]), side.num_intervals() - before - after);
        EXPECT_NEAR(std::accumulate(of[node].begin(), of[node].end(), 0.0), total, 1e-9);
        for (std::size_t k = 1; k < of[node].size(); ++k)
          EXPECT_LE(std::abs(std::log(of[node][k] / of[node][k - 1])), std::log(limit) * (1 + 1e-6));
        EXPECT_EQ(of[node].size(), of[1].size());
        for (std::size_t k = 0; k < of[node].size(); ++k) EXPECT_NEAR(of[node][k], of[1][k], 1e-9);
      }
    }
}

/// An annulus of two halves: lines along the circles close, across the cuts.
TEST(LineIntervals, LinesMayBeClosed) {
  const PlannedWalls p(wall_samples::annulus_of_half_circles(), 0.3,
                       {"side_1:first=0.01,layers=2", "side_2:first=0.01,layers=2"}, order);
  const BlockLines lines = line_intervals(p.measured, p.plan, p.divisions, limit, order);
  for (const layers::BlockLineLengths& block : lines)
    for (const auto& direction : block)
      for (std::size_t node = 1; node + 1 < direction.size(); ++node) {
        ASSERT_FALSE(direction[node].empty());
        for (const double length : direction[node]) EXPECT_GT(length, 0);
      }
}

TEST(CorrectFactors, AreOneWhereTheMeshHasTheIntervals) {
  const PlannedWalls p = layered_row();
  LinePlan lines;
  lines.lengths = line_intervals(p.measured, p.plan, p.divisions, limit, order);
  correct_factors(p.measured, p.plan, p.divisions, mesh_of(p, lines), limit, lines);
  int num_factors = 0;
  for (const layers::BlockLineLengths& block : lines.factors)
    for (const auto& direction : block)
      for (const std::vector<double>& line : direction)
        for (const double factor : line) {
          EXPECT_NEAR(factor, 1, 1e-3);
          ++num_factors;
        }
  EXPECT_GT(num_factors, 0);
}

TEST(CorrectFactors, MultiplyThoseBefore) {
  const PlannedWalls p = layered_row();
  LinePlan once;
  once.lengths = line_intervals(p.measured, p.plan, p.divisions, limit, order);
  const QuadMesh mesh = mesh_of(p, once);
  LinePlan twice = once;
  correct_factors(p.measured, p.plan, p.divisions, mesh, limit, once);
  twice.factors = once.lengths;
  for (layers::BlockLineLengths& block : twice.factors)
    for (auto& direction : block)
      for (std::vector<double>& line : direction) std::ranges::fill(line, 2.0);
  correct_factors(p.measured, p.plan, p.divisions, mesh, limit, twice);
  for (std::size_t k = 0; k < once.factors[0][0][1].size(); ++k)
    EXPECT_EQ(twice.factors[0][0][1][k], 2 * once.factors[0][0][1][k]);
}

/// Blocks and directions without lengths stay as they are.
TEST(CorrectFactors, OfDirectionsWithoutLengthsAreNone) {
  const PlannedWalls p = layered_row();
  LinePlan lines;
  lines.lengths = line_intervals(p.measured, p.plan, p.divisions, limit, order);
  const QuadMesh mesh = mesh_of(p, lines);
  lines.lengths[0][0].clear();
  correct_factors(p.measured, p.plan, p.divisions, mesh, limit, lines);
  for (const std::vector<double>& line : lines.factors[0][0]) EXPECT_TRUE(line.empty());
  EXPECT_FALSE(lines.factors[1][0][1].empty());
}

}  // namespace
}  // namespace quadrille::growth
