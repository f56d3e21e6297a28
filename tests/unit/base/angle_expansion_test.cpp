#include "base/angle_expansion.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"

namespace quadrille {
namespace {

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
