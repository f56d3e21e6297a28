#include "triangulate/size_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/vec2.hpp"

namespace quadrille::triangulate {
namespace {

double area(const SizeSources& sources) {
  double sum = 0;
  for (const SizeTriangle& t : sources.triangles)
    sum += norm(cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0])) / 2;
  return sum;
}

/// In the plane.
void add_triangles(SizeSources& sources) {
  std::vector<Vec2> positions;
  for (const SizeBall& point : sources.points) positions.push_back({point.position.x, point.position.y});
  add_size_triangles(sources, positions);
}

TEST(SizeTriangles, CoverTheHullWithTheSizesOfThePoints) {
  SizeSources sources;
  sources.points = {{{0, 0}, 1, 0}, {{2, 0}, 2, 0}, {{2, 1}, 3, 0}, {{0, 1}, 4, 0}, {{0.7, 0.4}, 5, 0}};
  add_triangles(sources);
  EXPECT_EQ(sources.triangles.size(), 4u);
  EXPECT_NEAR(area(sources), 2, 1e-12);
  for (const SizeTriangle& t : sources.triangles)
    for (int k = 0; k < 3; ++k)
      for (const SizeBall& point : sources.points) {
        if (point.position == t.corners[k]) {
          EXPECT_EQ(point.size, t.sizes[k]);
        }
      }
}

TEST(SizeTriangles, OfTwoPointsInOnePlaceTheFinerOneCounts) {
  SizeSources sources;
  sources.points = {{{0, 0}, 1, 0}, {{1, 0}, 1, 0}, {{0, 1}, 1, 0}, {{0, 0}, 0.5, 0}, {{1, 0}, 2, 0}};
  add_triangles(sources);
  ASSERT_EQ(sources.triangles.size(), 1u);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(sources.triangles[0].sizes[k], sources.triangles[0].corners[k] == Vec3{} ? 0.5 : 1);
}

TEST(SizeTriangles, OnACurvedFaceTheChartDecidesWhichPointsAreJoined) {
  SizeSources sources;
  sources.points = {{{0, 0, 1}, 1, 0}, {{1, 0, 0}, 2, 0}, {{0, 1, 0}, 3, 0}};
  add_size_triangles(sources, {{0, 0}, {1, 0}, {0, 1}});
  ASSERT_EQ(sources.triangles.size(), 1u);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(sources.triangles[0].sizes[k], sources.triangles[0].corners[k] == (Vec3{0, 0, 1})   ? 1
                                             : sources.triangles[0].corners[k] == (Vec3{1, 0, 0}) ? 2
                                                                                                  : 3);
}

TEST(SizeTriangles, PointsInOneLineHaveNone) {
  SizeSources sources;
  sources.points = {{{0, 0}, 1, 0}, {{1, 1}, 1, 0}, {{2, 2}, 1, 0}};
  add_triangles(sources);
  EXPECT_TRUE(sources.triangles.empty());
}

}  // namespace
}  // namespace quadrille::triangulate
