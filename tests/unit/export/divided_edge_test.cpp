#include "export/divided_edge.hpp"

#include <gtest/gtest.h>

#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

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
