#include "placement/half_planes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace quadrille::placement {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

TEST(HalfPlanes, TheNearestCommonPointIsTheTargetAFootOrACrossing) {
  EXPECT_EQ(nearest_common_point({{{1, 0}, -1}}, {0.5, 2}, everywhere), (Vec2{0.5, 2}));
  EXPECT_EQ(nearest_common_point({{{1, 0}, 1}}, {0.5, 2}, everywhere), (Vec2{1, 2}));
  const auto crossing = nearest_common_point({{{1, 0}, 1}, {{0.6, 0.8}, 3.8}}, {0, 0}, everywhere);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(distance(*crossing, {2.28, 3.04}), 0, 1e-12) << "the foot on the second line keeps the first";
  const auto corner = nearest_common_point({{{1, 0}, 1}, {{0, 1}, 2}}, {0, 0}, everywhere);
  ASSERT_TRUE(corner);
  EXPECT_NEAR(distance(*corner, {1, 2}), 0, 1e-12);
}

TEST(HalfPlanes, ThereIsNoCommonPointOutOfReachOrBetweenOppositePlanes) {
  EXPECT_FALSE(nearest_common_point({{{1, 0}, 1}}, {0, 0}, 0.9));
  EXPECT_FALSE(nearest_common_point({{{1, 0}, 1}, {{-1, 0}, -0.5}}, {0, 0}, everywhere));
}

TEST(HalfPlanes, WhereThereIsNoRoomAllWallsAreMissedByTheSameAmount) {
  const Vec2 middle = nearest_point_with_least_shortfall({{{1, 0}, 1, true}, {{-1, 0}, 0.5, true}}, {0, 3}, 9, 1e-9);
  EXPECT_NEAR(distance(middle, {0.25, 3}), 0, 1e-8);
}

TEST(HalfPlanes, OtherBoundsAreKeptAllTheSame) {
  const Vec2 at_bound = nearest_point_with_least_shortfall({{{1, 0}, 1, true}, {{-1, 0}, -0.5, false}}, {}, 9, 1e-9);
  EXPECT_NEAR(distance(at_bound, {0.5, 0}), 0, 1e-8);
}

TEST(HalfPlanes, TheReachLimitsTheMove) {
  const Vec2 at_reach = nearest_point_with_least_shortfall({{{1, 0}, 1, true}}, {}, 0.25, 1e-9);
  EXPECT_NEAR(distance(at_reach, {0.25, 0}), 0, 1e-8);
}

TEST(HalfPlanes, NearlyOppositeWallsMoveNothingAlongThem) {
  const Vec2 tilted{-std::cos(1e-10), std::sin(1e-10)};
  const Vec2 middle = nearest_point_with_least_shortfall({{{1, 0}, 1, true}, {tilted, 1, true}}, {}, 1, 1e-7);
  EXPECT_NEAR(norm(middle), 0, 1e-6);
}

}  // namespace
}  // namespace quadrille::placement
