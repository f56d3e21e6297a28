#include "base/angle_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"

namespace quadrille {

namespace {

// Adds to each sum an angle of its own: first + i * step.
void add(AngleSums& sums, double size, double first, double step, int times) {
  AngleSums::Values x, y;
  for (int i = 0; i < AngleSums::width; ++i) {
    x[i] = size * std::cos(first + i * step);
    y[i] = size * std::sin(first + i * step);
  }
  sums.add(x, y, times);
}

TEST(AngleSums, OfNothingAreZero) {
  for (int i = 0; i < AngleSums::width; ++i) EXPECT_EQ(AngleSums().value(i), 0);
}

TEST(AngleSums, AddAnglesTimesTheirFactors) {
  AngleSums sums;
  add(sums, 2, 0.3, 0.01, 1);
  add(sums, 0.1, -0.5, 0.02, 3);
  add(sums, 1, 0.7, -0.1, -2);
  add(sums, 1, 1.5, 0, 0);
  for (int i = 0; i < AngleSums::width; ++i)
    EXPECT_NEAR(sums.value(i), 0.3 + 0.01 * i + 3 * (-0.5 + 0.02 * i) - 2 * (0.7 - 0.1 * i), 1e-14);
}

TEST(AngleSums, CountWholeTurnsInBothDirections) {
  for (const double angle : {1.4, -1.4, 0.01, -0.01, half_pi, -half_pi}) {
    AngleSums sums;
    for (int i = 1; i <= 1000; ++i) {
      add(sums, 1, angle, 0, 1);
      for (int k = 0; k < AngleSums::width; ++k)
        ASSERT_NEAR(sums.value(k), i * angle, 1e-12) << angle << " times " << i;
    }
    add(sums, 1, angle, 0, -1000);
    for (int k = 0; k < AngleSums::width; ++k) EXPECT_NEAR(sums.value(k), 0, 1e-12);
  }
}

TEST(AngleSums, CountTheTurnsOfEachSum) {
  AngleSums sums;
  for (int i = 0; i < 100; ++i) add(sums, 1, -1.4, 0.4, 1);  // from -1.4 to 1.4
  for (int i = 0; i < AngleSums::width; ++i) EXPECT_NEAR(sums.value(i), 100 * (-1.4 + 0.4 * i), 1e-12);
}

TEST(AngleSums, NeitherOverflowNorVanish) {
  AngleSums sums;
  for (int i = 0; i < 500; ++i) add(sums, 1e200, 0.1, 0, 1);
  for (int i = 0; i < 500; ++i) add(sums, 1e-200, 0.1, 0, 1);
  for (int i = 0; i < AngleSums::width; ++i) EXPECT_NEAR(sums.value(i), 100, 1e-11);
}

const Vec2 centre{3, -1};
constexpr double radius = 0.2;

TEST(AngleExpansion, OfNothingIsZero) { EXPECT_EQ(AngleExpansion(centre, radius).at(centre), Vec2{}); }

TEST(AngleExpansion, SumsTheAnglesOfPointsAtAnyDistance) {
  AngleExpansion sum(centre, radius);
  std::vector<Vec2> points;
  for (int i = 0; i < 60; ++i) points.push_back(centre + (3.001 * radius * std::pow(1.3, i)) * unit(2.4 * i));
  const auto weight = [](int i) { return Vec2{std::sin(i + 1.0), std::cos(3.0 * i)}; };
  for (int i = 0; i < 60; ++i) sum.add(points[i], weight(i));
  for (int k = 0; k < 40; ++k) {
    const Vec2 x = centre + (radius * k / 40.0) * unit(1.9 * k);
    Vec2 expected;
    for (int i = 0; i < 60; ++i) {
      const Vec2 a = centre - points[i], b = x - points[i];
      expected += weight(i) * std::atan2(cross(a, b), dot(a, b));
    }
    EXPECT_NEAR(distance(sum.at(x), expected), 0, 2e-15) << k;
  }
}

TEST(AngleExpansion, MayBeMovedToADiscInside) {
  AngleExpansion sum(centre, radius);
  for (int i = 0; i < 20; ++i)
    sum.add(centre + (3.001 * radius * std::pow(1.3, i)) * unit(2.4 * i), {std::sin(i + 1.0), std::cos(3.0 * i)});
  const Vec2 other_centre = centre + Vec2{0.11, -0.05};
  const AngleExpansion inside = sum.inside(other_centre, 0.07);
  for (int k = 0; k < 40; ++k) {
    const Vec2 x = other_centre + (0.07 * k / 40.0) * unit(1.9 * k);
    EXPECT_NEAR(distance(inside.at(x), sum.at(x) - sum.at(other_centre)), 0, 2e-15) << k;
  }
}

TEST(AngleExpansion, ContainsItsDisc) {
  const AngleExpansion sum(centre, radius);
  EXPECT_TRUE(sum.contains(centre + Vec2{0, 0.199}));
  EXPECT_FALSE(sum.contains(centre + Vec2{0.15, 0.15}));
}

TEST(AngleExpansion, ASegmentIsNearIfAnyOfItsPointsIs) {
  const AngleExpansion sum(centre, radius);
  const auto is_far = [&](Vec2 a, Vec2 b) { return sum.is_far(centre + a, centre + b); };
  EXPECT_TRUE(is_far({0.61, 0}, {0.61, 0}));
  EXPECT_FALSE(is_far({0.59, 0}, {0.59, 0}));
  EXPECT_FALSE(is_far({5, 0.1}, {-5, 0.1}));
  EXPECT_TRUE(is_far({5, 0.1}, {1, 0.1}));
  EXPECT_TRUE(is_far({5, 0.61}, {-5, 0.61}));
}

}  // namespace

}  // namespace quadrille
