#include "offset/chart_heights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"

namespace quadrille::offset {
namespace {

TEST(ChartHeights, AreLengthsInThePlane) {
  const ChartHeights heights{CadFace{}};
  EXPECT_TRUE(heights.is_planar());
  EXPECT_EQ(heights.in_chart({{0, 0}, {0, 1}}, 0.25), 0.25);
  EXPECT_EQ(heights.in_space({{0, 0}, {0, 1}}, 0.25), 0.25);
  EXPECT_EQ(heights.slope_in_chart({{0, 0}, {0, 1}}, 1, 0.25, 0.5), 0.5);
}

/// Of a meridian of the sphere, from the rim of the cap to its pole.
TEST(ChartHeights, AreLengthsOfStraightLinesInSpace) {
  const CadFace cap = samples::cap_face();
  const ChartHeights heights(cap);
  const WallFoot foot{{0, 0.8}, {0, -1}};
  for (const double height : {1e-6, 0.01, 0.1, 0.3}) {
    const double in_space = 2 * (std::atan(0.8) - std::atan(0.8 - height));
    EXPECT_NEAR(heights.in_space(foot, height), in_space, (1e-10 + 2e-6 * height) * in_space);
    EXPECT_NEAR(heights.in_chart(foot, heights.in_space(foot, height)), height, 1e-14);
  }
}

TEST(ChartHeights, TheSlopeIsTheDerivativeAlongTheWall) {
  const CadFace cap = samples::cap_face();
  const ChartHeights heights(cap);
  // A wall through (0.2, 0.3) with the radius 2, bent to its left; the height in space falls along it.
  const auto foot = [](double s) {
    const Vec2 n = unit(0.7 + s / 2);
    return WallFoot{Vec2{0.2, 0.3} + 2 * (unit(0.7) - n), n};
  };
  const auto in_chart = [&](double s) { return heights.in_chart(foot(s), 0.2 - 0.1 * s); };
  constexpr double step = 1e-4;
  const double slope = (in_chart(step) - in_chart(-step)) / (2 * step);
  EXPECT_NEAR(heights.slope_in_chart(foot(0), 0.5, in_chart(0), -0.1), slope, 1e-8);
}

TEST(ChartHeights, AHalfHasThoseOfItsWhole) {
  const CadFace cap = samples::cap_face();
  ChartHeights heights(cap);
  heights.add_mirror({{0, 0}, {1, 0}, {0}});
  const WallFoot above{{0.1, 0.4}, unit(-2)}, below{{0.1, -0.4}, unit(2)};
  EXPECT_NEAR(heights.in_chart(above, 0.9), heights.in_chart(below, 0.9), 1e-15);
  EXPECT_NEAR(heights.slope_in_chart(above, 0.3, 0.2, 0), -heights.slope_in_chart(below, 0.3, 0.2, 0), 1e-12);
}

}  // namespace
}  // namespace quadrille::offset
