#include "adapt/order_policy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::adapt {
namespace {

// Two elements of order 3 with all coefficients 0.
Field empty_field() {
  Field field;
  field.mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 1);
  field.elem_order = {3, 3};
  field.coef_offsets = {0, 10, 20};
  field.u.assign(20, 0.0);
  field.v.assign(20, 0.0);
  return field;
}

TEST(Sensor, IsZeroForAComponentThatVanishes) {
  const Field field = empty_field();
  for (const SensorKind kind : {SensorKind::vector, SensorKind::u, SensorKind::v}) {
    EXPECT_EQ(element_sensors(field, kind), std::vector<double>({0, 0}));
  }
}

TEST(Sensor, IsTheShareOfTheHighestDegree) {
  Field field = empty_field();
  field.u[0] = 3;   // a field longer than 1: the sensor is relative
  field.u[9] = 4;   // degree 3
  field.v[5] = 12;  // degree 2
  field.v[16] = 1e-3;
  field.u[14] = 0.5;  // element 1 is shorter than a unit field, whose square is 2 on the reference triangle
  const std::vector<double> both = element_sensors(field, SensorKind::vector);
  EXPECT_NEAR(both[0], 16.0 / (25 + 144), 1e-15);
  EXPECT_NEAR(both[1], 1e-6 / 2, 1e-20);
  EXPECT_NEAR(element_sensors(field, SensorKind::u)[0], 16.0 / 25, 1e-15);
  EXPECT_EQ(element_sensors(field, SensorKind::u)[1], 0);
  EXPECT_EQ(element_sensors(field, SensorKind::v)[0], 0);
}

TEST(Sensor, OfDegreesAddUpToTheWholeField) {
  Field field = empty_field();
  field.u = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  field.v[0] = 12;
  const double all = 385 + 144;
  const std::vector<std::vector<double>> sensors = degree_sensors(field, SensorKind::vector, SensorScale::absolute);
  ASSERT_EQ(sensors.size(), 2u);
  const std::vector<double> expected{(1 + 144) / all, (4 + 9) / all, (16 + 25 + 36) / all, (49 + 64 + 81 + 100) / all};
  ASSERT_EQ(sensors[0].size(), expected.size());
  for (std::size_t d = 0; d < expected.size(); ++d) EXPECT_NEAR(sensors[0][d], expected[d], 1e-15) << "degree " << d;
  EXPECT_EQ(sensors[1], std::vector<double>(4, 0.0));
  EXPECT_EQ(sensors[0].back(), element_sensors(field, SensorKind::vector)[0]);
}

TEST(Sensor, OfFanElementsCountsBySize) {
  Field field = empty_field();
  field.mesh.vertices = {{0, 0}, {1, 0}, {0, 1}, {0.1, 0}, {0, 0.1}};
  field.mesh.elem2vertices = {{0, 1, 2}, {0, 3, 4}};
  field.mesh.elem_layer = {-1, 0};
  field.u[9] = field.u[19] = 1;
  const std::vector<double> sensors = element_sensors(field, SensorKind::vector);
  EXPECT_NEAR(sensors[0], 0.5, 1e-15);
  EXPECT_NEAR(sensors[1], 0.005, 1e-15);
}

TEST(Sensor, NearlyEqualOnesAreDecidedTogether) {
  EXPECT_EQ(equalized({1e-18, 3e-20, 1.0001e-18, 0.97e-18, 0}),
            std::vector<double>({1.0001e-18, 3e-20, 1.0001e-18, 1.0001e-18, 0}));
  // A chain does not run away: what is 5 % below its group's greatest starts a new group.
  EXPECT_EQ(equalized({1.0, 0.96, 0.92}), std::vector<double>({1.0, 1.0, 0.92}));
}

TEST(Sensor, RelativeToTheElementAloneIsThePapers) {
  Field field = empty_field();
  field.mesh.elem_layer = {-1, 0};  // no weights
  field.u[0] = 1;
  field.v[9] = 1e-12;  // all there is of v
  field.v[10] = field.v[19] = 1e-6;
  EXPECT_EQ(element_sensors(field, SensorKind::v, SensorScale::relative), std::vector<double>({1, 0.5}));
  EXPECT_EQ(element_sensors(field, SensorKind::u, SensorScale::relative),
            std::vector<double>({0, 0}));  // 0/0 on element 1
  EXPECT_NEAR(element_sensors(field, SensorKind::vector, SensorScale::relative)[0], 1e-24, 1e-36);
}

TEST(Sensor, ScalesHaveNames) {
  EXPECT_EQ(enum_name(SensorScale::absolute), "absolute");
  EXPECT_EQ(enum_name(SensorScale::relative), "relative");
}

TEST(Sensor, KindsHaveNames) {
  EXPECT_EQ(enum_name(SensorKind::vector), "vector");
  EXPECT_EQ(enum_name(SensorKind::u), "u");
  EXPECT_EQ(enum_name(SensorKind::v), "v");
}

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
