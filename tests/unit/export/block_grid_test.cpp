#include "export/block_grid.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

/// Every element once, neighbours in a row share a side, and the four sides go round.
void expect_grids(const QuadMesh& mesh, const std::vector<BlockGrid>& grids) {
  std::set<int> elems;
  for (const BlockGrid& g : grids) {
    ASSERT_EQ(g.cells.size(), static_cast<std::size_t>(g.num_i * g.num_j));
    const std::vector<int> vertices = g.vertices(mesh);
    const auto vertex = [&](int i, int j) { return vertices[j * (g.num_i + 1) + i]; };
    for (int j = 0; j < g.num_j; ++j)
      for (int i = 0; i < g.num_i; ++i) {
        const SkeletonEdge at = g.cell(i, j);
        EXPECT_TRUE(elems.insert(at.elem).second);
        EXPECT_EQ(mesh.elem_block[at.elem], g.block);
        const std::array<int, 4> expected{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)};
        for (int k = 0; k < 4; ++k) EXPECT_EQ(side_start(mesh, at.elem, (at.side + k) % 4), expected[k]);
      }
    for (int k = 0; k < 4; ++k) {
      const std::vector<SkeletonEdge> side = g.side(k), next = g.side((k + 1) % 4);
      EXPECT_EQ(side.size(), static_cast<std::size_t>(k % 2 == 0 ? g.num_i : g.num_j));
      EXPECT_EQ(side_nodes(mesh, side.back().elem, side.back().side).back(),
                side_start(mesh, next.front().elem, next.front().side));
    }
  }
  EXPECT_EQ(elems.size(), mesh.elem_block.size());
}

TEST(BlockGrid, LHasThreeGrids) {
  const QuadMesh mesh = refined(hand_made::l_shape(), {0.3, 2});
  const auto grids = block_grids(mesh);
  ASSERT_TRUE(grids);
  EXPECT_EQ(grids->size(), 3u);
  expect_grids(mesh, *grids);
}

TEST(BlockGrid, ElementsMayBeTurned) {
  QuadMesh mesh = refined(hand_made::l_shape(), {0.3, 1});
  for (std::size_t e = 0; e < mesh.elem_block.size(); e += 2)  // order 1: nodes (0,0) (1,0) (0,1) (1,1)
    mesh.elem_nodes = [nodes = mesh.elem_nodes, e]() mutable {
      const std::array<int, 4> old{nodes[4 * e], nodes[4 * e + 1], nodes[4 * e + 2], nodes[4 * e + 3]};
      nodes[4 * e] = old[1], nodes[4 * e + 1] = old[3], nodes[4 * e + 2] = old[0], nodes[4 * e + 3] = old[2];
      return nodes;
    }();
  const auto grids = block_grids(mesh);
  ASSERT_TRUE(grids);
  expect_grids(mesh, *grids);
}

TEST(BlockGrid, RingHasNone) { EXPECT_FALSE(block_grids(refined(hand_made::cut_annulus(1), {0.3, 2}))); }

TEST(BlockGrid, CutRunsOnThroughTheNeighbour) {
  const QuadMesh mesh = refined(hand_made::l_shape(), {0.3, 2});
  const auto grids = block_grids(mesh);
  ASSERT_TRUE(grids);
  int node = -1;  // the first vertex on y = 0 with 0 < x < 1: a line through two blocks, up to y = 2
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
    if (mesh.nodes[k].y == 0 && mesh.nodes[k].x > 0.1 && mesh.nodes[k].x < 0.9 && node < 0)
      for (const BlockGrid& g : *grids)
        for (const int v : g.vertices(mesh))
          if (v == static_cast<int>(k)) node = v;
  ASSERT_GE(node, 0);
  const std::vector<BlockGrid> cut = cut_grids(mesh, *grids, {node});
  EXPECT_EQ(cut.size(), 5u);
  expect_grids(mesh, cut);
  EXPECT_EQ(cut_grids(mesh, cut, {node}).size(), 5u);  // a corner already
  EXPECT_EQ(cut_grids(mesh, *grids, {}).size(), 3u);
}

DividedEdge line(Vec2 a, Vec2 b, const std::vector<double>& fractions) {
  DividedEdge edge;
  edge.fractions = fractions;
  for (const double w : edge.weights()) edge.vertices.push_back(a + w * (b - a));
  edge.is_straight = true;
  return edge;
}

TEST(DividedEdge, StraightSideOfTwoElements) {
  const DividedEdge edge = divided_edge(two_quads(), {{0, 0}, {1, 0}});
  EXPECT_TRUE(edge.is_straight);
  EXPECT_EQ(edge.fractions, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(edge.weights(), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(edge.vertices, (std::vector<Vec2>{{0, 0}, {2, 0}, {4, 0}}));
}

TEST(DividedEdge, SplinePassesTheVerticesAtTheirShares) {
  const QuadMesh mesh = two_quads();
  const DividedEdge edge = divided_edge(mesh, {{1, 2}, {0, 2}});  // from (4, 2) over (3, 2.5) to (0, 2)
  EXPECT_FALSE(edge.is_straight);
  ASSERT_EQ(edge.inner.size(), 7u);
  EXPECT_EQ(edge.inner[1], (Vec2{3, 2.5}));
  EXPECT_EQ(edge.inner[3], (Vec2{2, 2}));
  double length = 0, before = 0;  // of the polygon, and of its part up to (2, 2)
  std::vector<Vec2> polygon{{4, 2}};
  polygon.insert(polygon.end(), edge.inner.begin(), edge.inner.end());
  polygon.push_back({0, 2});
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    length += distance(polygon[k - 1], polygon[k]);
    if (k == 4) before = length;
  }
  EXPECT_NEAR(edge.fractions[0], before / length, 1e-15);
  EXPECT_EQ(edge.reversed().inner[3], (Vec2{2, 2}));
  EXPECT_EQ(edge.reversed().fractions[1], edge.fractions[0]);
}

TEST(BlockMeshPoints, RectangleWithEqualSharesIsAGrid) {
  const std::vector<double> x{0.2, 0.3, 0.5}, y{0.75, 0.25};
  const std::vector<Vec2> points = block_mesh_points(line({0, 0}, {2, 0}, x), line({2, 0}, {2, 1}, y),
                                                     line({0, 1}, {2, 1}, x), line({0, 0}, {0, 1}, y));
  ASSERT_EQ(points.size(), 12u);
  EXPECT_NEAR(distance(points[5], {0.4, 0.75}), 0, 1e-15);
  EXPECT_NEAR(distance(points[6], {1, 0.75}), 0, 1e-15);
}

TEST(BlockMeshPoints, AreTheVerticesOnTheSides) {
  const std::vector<double> a{0.1, 0.4, 0.5}, b{0.3, 0.3, 0.4}, c{0.6, 0.4}, d{0.5, 0.5};
  DividedEdge bottom = line({0, 0}, {2, 0.1}, a), right = line({2, 0.1}, {2.5, 1}, c);
  const DividedEdge top = line({0.2, 1.5}, {2.5, 1}, b), left = line({0, 0}, {0.2, 1.5}, d);
  bottom.vertices[1].y -= 0.2;
  bottom.vertices[2].y -= 0.1;
  right.vertices[1].x += 0.3;
  const std::vector<Vec2> points = block_mesh_points(bottom, right, top, left);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(distance(points[i], bottom.vertices[i]), 0, 1e-15);
    EXPECT_NEAR(distance(points[8 + i], top.vertices[i]), 0, 1e-15);
  }
  EXPECT_NEAR(distance(points[4], left.vertices[1]), 0, 1e-15);
  EXPECT_NEAR(distance(points[7], right.vertices[1]), 0, 1e-15);
}

}  // namespace

}  // namespace quadrille::exports
