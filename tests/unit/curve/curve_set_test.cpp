#include "curve/curve_set.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

TEST(CurveSet, FindsThePointThatIsFarthestFromTheNearestOfManyCurves) {
  const CurveSet set({circular_arc({0, 0}, 1, 0, 2 * pi), circular_arc({5, 0}, 2, 0, 2 * pi), segment({0, 4}, {5, 4})});
  const std::vector<Vec2> points{{0, 1.5}, {5, 2.25}, {2.5, 3.75}, {0, 0.75}};
  EXPECT_NEAR(set.farthest(points).distance, 0.5, 1e-14);
  EXPECT_EQ(set.farthest(points).position, points[0]);
  // On the second circle's left, nearer to it than to the first, to which the point before was nearest.
  EXPECT_NEAR(set.farthest({{1.25, 0}, {2.5, 0}}).distance, 0.5, 1e-14);
}

TEST(CurveSet, AGuessOnTheFarSideOfACircleIsNotTaken) {
  const CurveSet set({circular_arc({0, 0}, 1, 0, 2 * pi)});
  EXPECT_NEAR(set.farthest({{-1, 0}, {0.5, 0}}).distance, 0.5, 1e-14);
}

TEST(CurveSet, FindsTheNearestOfSoManyCurvesThatTheyAreGrouped) {
  std::vector<Nurbs> circles;
  for (int i = 0; i < 50; ++i) circles.push_back(circular_arc({3.0 * (i % 7), 3.0 * ((3 * i) % 50)}, 1, 0, 2 * pi));
  const CurveSet set(circles);
  for (int i = 0; i < 50; ++i) {
    const int first = 13 * i % 50;
    const Vec2 on{3.0 * (first % 7), 3.0 * ((3 * first) % 50) + 1}, inside{3.0 * (i % 7) + 0.1, 3.0 * ((3 * i) % 50)};
    EXPECT_NEAR(set.farthest({on, inside}).distance, 0.9, 1e-13);
    EXPECT_EQ(set.farthest({on, inside}).position, inside);
  }
}

TEST(CurveSet, EndsOfCurvesCount) {
  const CurveSet set({segment({0, 0}, {1, 0})});
  EXPECT_NEAR(set.farthest({{0.5, 0.1}, {4, 4}}).distance, 5, 1e-14);
  EXPECT_EQ(CurveSet({}).farthest({{1, 1}}).distance, 0);
}

TEST(CurveSet, PolesThatCoincideDoNotStopIt) {
  // The derivative vanishes at the start.
  const Nurbs curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {1, 0}, {2, 0}}, {1, 1, 1, 1}};
  EXPECT_NEAR(CurveSet({curve}).farthest({{0, 0}, {1.3, 0.25}}).distance, 0.25, 1e-12);
}

}  // namespace
}  // namespace quadrille::curve
