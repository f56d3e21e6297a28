#include "adapt/order_policy.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

// Sensors that decay by a factor of 100 from degree to degree, up to `order`.
std::vector<double> geometric(int order) {
  std::vector<double> sensors;
  for (int d = 0; d <= order; ++d) sensors.push_back(std::pow(100, -d));
  return sensors;
}

TEST(PredictedOrder, InterpolatesWhereTheModesReachTheTarget) {
  EXPECT_NEAR(predicted_order(geometric(9), 1e-8, 1), 4, 1e-9);
  EXPECT_NEAR(predicted_order(geometric(9), 1e-9, 1), 4.5, 1e-9);
  EXPECT_NEAR(predicted_order(geometric(9), 1e-9, 0.5), 4.5, 1e-9);  // no rate is needed
}

TEST(PredictedOrder, ExtrapolatesAtTheTrustedPartOfTheRate) {
  EXPECT_NEAR(predicted_order(geometric(5), 1e-14, 1), 7, 1e-9);
  EXPECT_NEAR(predicted_order(geometric(5), 1e-14, 0.5), 10, 1e-9);  // from degree 4, three degrees at the full rate
}

TEST(PredictedOrder, IsAboveAnOrderThatMissesTheTarget) {
  std::vector<double> sensors = geometric(5);
  sensors[5] = sensors[4];
  EXPECT_GT(predicted_order(sensors, 0.99 * sensors[5], 1), 5);
}

TEST(PredictedOrder, NoticesADecayThatSlowsDownAtTheHighestDegree) {
  std::vector<double> sensors = geometric(6);
  sensors[6] = sensors[5] / 4;
  EXPECT_NEAR(predicted_order(geometric(6), 1e-14, 1), 7, 1e-9);
  EXPECT_NEAR(predicted_order(sensors, 1e-14, 1), 6 + std::log(sensors[6] / 1e-14) / std::log(100), 1e-9);
}

TEST(GoodEnough, IsAFieldWithFewSensorsALittleAboveTheLimit) {
  std::vector<double> sensors(2000, 1e-9);
  EXPECT_TRUE(is_good_enough(sensors, 1e-8));
  sensors[7] = sensors[8] = 9e-8;
  EXPECT_TRUE(is_good_enough(sensors, 1e-8));
  sensors[9] = 1.1e-8;
  EXPECT_FALSE(is_good_enough(sensors, 1e-8));  // three of 2000
  sensors[8] = sensors[9] = 1e-9;
  sensors[7] = 1.1e-7;
  EXPECT_FALSE(is_good_enough(sensors, 1e-8));         // eleven times the limit
  EXPECT_FALSE(is_good_enough({1.1e-8, 0, 0}, 1e-8));  // one of three
}

TEST(PredictedOrder, TakesTheGreatestOfTheHigherDegrees) {
  std::vector<double> even = geometric(8);
  for (int d = 1; d < 8; d += 2) even[d] = 0;
  EXPECT_GT(predicted_order(even, 1e-10, 1), 4);
  EXPECT_LE(predicted_order(even, 1e-10, 1), 6);
  even.push_back(0);  // degree 9 vanishes too, but degree 10 need not
  EXPECT_GT(predicted_order(even, 1e-20, 1), 9);
}

TEST(PredictedOrder, FollowsTheChangeOfTheRate) {
  std::vector<double> rough, smooth;
  for (int d = 0; d <= 8; ++d) {
    rough.push_back(std::pow(d + 1, -8));
    smooth.push_back(std::exp(-0.3 * d * d));
  }
  // What these sequences reach themselves.
  EXPECT_NEAR(predicted_order(rough, std::pow(13, -8), 1), 12, 1);
  EXPECT_NEAR(predicted_order(smooth, std::exp(-0.3 * 12 * 12), 1), 12, 1);
}

TEST(PredictedOrder, IsFiniteForModesThatDoNotDecay) {
  EXPECT_LT(predicted_order(std::vector<double>(9, 1.0), 1e-18, 1), 1000);
  EXPECT_EQ(predicted_order(std::vector<double>(9, 0.0), 1e-18, 1), 0);
  EXPECT_GT(predicted_order({1}, 1e-18, 1), 0);
}

}  // namespace
}  // namespace quadrille::adapt
