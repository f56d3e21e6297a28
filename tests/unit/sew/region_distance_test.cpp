#include "sew/region_distance.hpp"

#include <gtest/gtest.h>

#include "regions.hpp"

namespace quadrille::sew {
namespace {

using namespace testing_regions;

TEST(RegionDistance, TheGapIsThatOfTheNearestPoints) {
  const auto regions = regions_of({{rectangle({0, 0}, {1, 1})}, {circle({2, 0.5}, 0.75)}, {rectangle({0, 0}, {1, 1})}});
  EXPECT_NEAR(gap_between(regions[0], regions[1]).size, 0.25, 1e-7);
  EXPECT_NEAR(distance(gap_between(regions[0], regions[1]).position, {1.125, 0.5}), 0, 1e-3);
  EXPECT_EQ(gap_between(regions[0], regions[2]).size, 0);
}

TEST(RegionDistance, NeighboursDoNotOverlap) {
  const auto regions = regions_of(
      {{rectangle({0, 0}, {1, 1}), hole({0.5, 0.5}, 0.2)}, {rectangle({1, 0}, {2, 1})}, {circle({0.5, 0.5}, 0.2)}});
  EXPECT_FALSE(overlap(regions[0], regions[1], 1e-9));
  EXPECT_FALSE(overlap(regions[0], regions[2], 1e-9));
}

TEST(RegionDistance, OverlapsHaveADepthAndAPlaceInBoth) {
  const auto regions =
      regions_of({{rectangle({0, 0}, {1, 1})}, {rectangle({0.75, 0.25}, {2, 0.75})}, {circle({0.5, 0.5}, 0.1)}});
  const auto found = overlap(regions[0], regions[1], 1e-9);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->size, 0.25, 0.05);
  const curve::CurveTree boundary = boundary_of(regions[0]);
  EXPECT_TRUE(boundary.winding_number(found->position) > 0 || boundary.nearest(found->position).distance < 1e-12);
  EXPECT_TRUE(overlap(regions[0], regions[2], 1e-9)) << "inside";
  EXPECT_FALSE(overlap(regions[0], regions[1], 0.5)) << "negligible";
}

}  // namespace
}  // namespace quadrille::sew
