#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "triangulate/delaunay.hpp"

namespace quadrille::triangulate {
namespace {

/// Inserts a closed polygon and constrains its sides; returns its first vertex.
int add_loop(ConstrainedDelaunay& delaunay, const std::vector<Vec2>& points) {
  std::vector<int> vertices;
  for (const Vec2 x : points) vertices.push_back(delaunay.insert(x));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_TRUE(delaunay.constrain(vertices[i], vertices[(i + 1) % vertices.size()]));
  return vertices.front();
}

const std::vector<Vec2> outer_square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const std::vector<Vec2> inner_square{{1, 1}, {3, 1}, {3, 3}, {1, 3}};

TEST(Delaunay, ASquareIsTwoTriangles) {
  ConstrainedDelaunay delaunay;
  add_loop(delaunay, outer_square);
  const auto triangles = delaunay.triangles();
  ASSERT_EQ(triangles.size(), 2u);
  int inner_edges = 0;
  for (const auto& triangle : triangles)
    for (const int neighbor : triangle.neighbors) inner_edges += neighbor >= 0;
  EXPECT_EQ(inner_edges, 2);
}

TEST(Delaunay, AHoleIsOutside) {
  ConstrainedDelaunay delaunay;
  add_loop(delaunay, outer_square);
  add_loop(delaunay, inner_square);
  const auto triangles = delaunay.triangles();
  // V - E + F = 0 for a ring: 8 - E + F with 3 F = 2 E - 8.
  EXPECT_EQ(triangles.size(), 8u);
}

TEST(Delaunay, NeighboursShareTheEdgeTheyAreNamedFor) {
  ConstrainedDelaunay delaunay;
  add_loop(delaunay, outer_square);
  delaunay.insert({1.5, 2.25});
  delaunay.insert({2.5, 1.25});
  const auto triangles = delaunay.triangles();
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
    for (int k = 0; k < 3; ++k) {
      const int j = triangles[i].neighbors[k];
      if (j < 0) continue;
      const int a = triangles[i].vertices[k], b = triangles[i].vertices[(k + 1) % 3];
      bool shares = false;
      for (int m = 0; m < 3; ++m)
        shares |=
            triangles[j].vertices[m] == b && triangles[j].vertices[(m + 1) % 3] == a && triangles[j].neighbors[m] == i;
      EXPECT_TRUE(shares);
    }
  }
}

TEST(Delaunay, TheSameTrianglesInWhateverSequenceThePointsCome) {
  const std::vector<Vec2> points{{0.5, 1.5}, {3.25, 2}, {2, 0.75}, {1.125, 3.25}};
  const auto places = [&](const std::vector<int>& sequence) {
    ConstrainedDelaunay delaunay;
    add_loop(delaunay, outer_square);
    std::vector<int> original(4 + points.size());
    for (int i = 0; i < 4; ++i) original[i] = i;
    for (const int i : sequence) original[delaunay.insert(points[i])] = 4 + i;
    std::vector<std::array<int, 3>> triangles;
    for (const auto& triangle : delaunay.triangles()) {
      std::array<int, 3> v{};
      for (int k = 0; k < 3; ++k) v[k] = original[triangle.vertices[k]];
      std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
      triangles.push_back(v);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  EXPECT_EQ(places({0, 1, 2, 3}), places({3, 1, 0, 2}));
}

TEST(Delaunay, AKnownPositionKeepsItsNumber) {
  ConstrainedDelaunay delaunay;
  EXPECT_EQ(delaunay.insert({1, 2}), 0);
  EXPECT_EQ(delaunay.insert({3, 2}), 1);
  EXPECT_EQ(delaunay.insert({1, 2}), 0);
}

TEST(Delaunay, AnInnerConstraintHasTheInsideOnBothSides) {
  for (const bool is_inner : {false, true}) {
    ConstrainedDelaunay delaunay;
    add_loop(delaunay, outer_square);
    std::vector<int> inner;
    for (const Vec2 x : {Vec2{1, 1}, Vec2{3, 1}, Vec2{2, 3}}) inner.push_back(delaunay.insert(x));
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(delaunay.constrain(inner[k], inner[(k + 1) % 3], is_inner));
    const auto triangles = delaunay.triangles();
    const auto found = std::find_if(triangles.begin(), triangles.end(), [&](const DelaunayTriangle& t) {
      return t.vertices == std::array{inner[0], inner[1], inner[2]};
    });
    ASSERT_EQ(found != triangles.end(), is_inner);
    if (is_inner) {
      EXPECT_EQ(found->neighbors, (std::array{-1, -1, -1}));
    }
  }
}

TEST(Delaunay, CrossingConstraintsAreRefused) {
  ConstrainedDelaunay delaunay;
  for (const Vec2 x : outer_square) delaunay.insert(x);
  EXPECT_TRUE(delaunay.constrain(0, 2));
  EXPECT_FALSE(delaunay.constrain(1, 3));
}

TEST(Delaunay, AConstraintThroughAThirdVertexIsRefused) {
  ConstrainedDelaunay delaunay;
  for (const Vec2 x : {Vec2{0, 0}, Vec2{1, 0}, Vec2{2, 0}, Vec2{1, 1}}) delaunay.insert(x);
  EXPECT_FALSE(delaunay.constrain(0, 2));
}

TEST(Delaunay, AReleasedConstraintOpensTheWay) {
  ConstrainedDelaunay delaunay;
  add_loop(delaunay, outer_square);
  const int hole = add_loop(delaunay, inner_square);
  for (int k = 0; k < 4; ++k) delaunay.release(hole + k, hole + (k + 1) % 4);
  // 8 vertices, 4 on the hull: 2 * 8 - 2 - 4.
  EXPECT_EQ(delaunay.triangles().size(), 10u);
}

}  // namespace
}  // namespace quadrille::triangulate
