#include "surface/space_extent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quadrille::surface {
namespace {

/// A quarter of the unit circle in the plane z = 2, from (1, 0) to (0, 1).
SpaceCurve quarter() { return {2, {0, 0, 0, 1, 1, 1}, {{1, 0, 2}, {1, 1, 2}, {0, 1, 2}}, {1, std::sqrt(0.5), 1}}; }

TEST(SpaceExtent, TheNearestPointOfACurveIsInsideOrAnEnd) {
  const Vec3 x{3, 4, 5};
  const CurveProjection foot = project(quarter(), x);
  EXPECT_NEAR(foot.distance, std::hypot(4, 3), 1e-12);
  EXPECT_LE(distance(foot.position, {0.6, 0.8, 2}), 1e-8);
  const CurveProjection end = project(quarter(), {5, -1, 2});
  EXPECT_EQ(end.t, 0);
  EXPECT_EQ(end.position, (Vec3{1, 0, 2}));
}

TEST(SpaceExtent, OfSeveralNearPointsTheNearestIsFound) {
  const SpaceCurve zigzag{1, {0, 0, 1, 2, 3, 3}, {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}}, {1, 1, 1, 1}};
  EXPECT_LE(distance(project(zigzag, {1, 1.5, 0}).position, {1, 1, 0}), 1e-12);
  EXPECT_LE(distance(project(zigzag, {2.9, 1.5, 0}).position, {3, 1, 0}), 1e-12);
}

TEST(SpaceExtent, TheDiameterIsTheGreatestDistanceOfNodes) {
  Chart chart;
  for (int i = 0; i <= 10; ++i) chart.space_nodes.push_back({0.1 * i, std::sin(0.3 * i), 0});
  chart.space_nodes.push_back({0, 0, 7});
  double greatest = 0;
  for (const Vec3 a : chart.space_nodes)
    for (const Vec3 b : chart.space_nodes) greatest = std::max(greatest, distance(a, b));
  EXPECT_NEAR(diameter(chart), greatest, 1e-12);
}

}  // namespace
}  // namespace quadrille::surface
