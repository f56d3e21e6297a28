#include "adapt/order_policy.hpp"

#include <gtest/gtest.h>

namespace quadrille::adapt {
namespace {

const AdaptOptions options{.raise_above = 1e-8, .lower_below = 1e-12, .min_order = 3, .max_order = 9};

TEST(OrderPolicy, IsTheTableOfAlgorithmOne) {
  EXPECT_EQ(decide(1e-6, 5, false, options), OrderChange::raise);
  EXPECT_EQ(decide(1e-10, 5, false, options), OrderChange::keep);
  EXPECT_EQ(decide(1e-14, 5, false, options), OrderChange::lower);
}

TEST(OrderPolicy, StopsAtTheLimits) {
  EXPECT_EQ(decide(1e-6, 9, false, options), OrderChange::keep);
  EXPECT_EQ(decide(1e-14, 3, false, options), OrderChange::keep);
}

TEST(OrderPolicy, NeverLowersWhatItHasRaised) {
  EXPECT_EQ(decide(1e-14, 5, true, options), OrderChange::keep);
  EXPECT_EQ(decide(1e-6, 5, true, options), OrderChange::raise);
}

}  // namespace
}  // namespace quadrille::adapt
