#include "draw/region_fields.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"

namespace quadrille::draw {
namespace {

TEST(RegionFields, LiftingsHoldInTheirOwnRegion) {
  Field field = samples::two_regions_field();
  field.liftings = {{4, {1, 0}, {0.5, -0.5}, {1, 0}}};  // of a joint of the right square
  const RegionFields regions(field);
  ASSERT_EQ(regions.evaluators.size(), 2u);
  Vec2 value;
  ASSERT_TRUE(regions.evaluators[0].value_at({0.5, 0.3}, value));
  EXPECT_NEAR(distance(value, {1, 0}), 0, 1e-12);
  ASSERT_TRUE(regions.evaluators[1].value_at({1.5, 0.3}, value));
  EXPECT_GT(distance(value, {1, 0}), 0.1);
  EXPECT_FALSE(regions.evaluators[0].value_at({1.5, 0.3}, value));
}

TEST(RegionFields, OneRegionIsTheField) {
  const Field field = samples::field();
  const RegionFields regions(field);
  ASSERT_EQ(regions.evaluators.size(), 1u);
  EXPECT_EQ(regions.fields[0].u, field.u);
}

TEST(RegionFields, EachRegionHasItsOwnPhase) {
  const RegionFields regions(samples::two_regions_phase_field());
  Vec2 value;
  ASSERT_TRUE(regions.evaluators[1].value_at({1.5, 0.3}, value));
  EXPECT_NEAR(distance(value, {1, 0}), 0, 1e-12) << "no terms, s = 0";
  ASSERT_TRUE(regions.evaluators[0].value_at({0.5, 0.3}, value));
  EXPECT_GT(distance(value, {1, 0}), 0.1);
}

}  // namespace
}  // namespace quadrille::draw
