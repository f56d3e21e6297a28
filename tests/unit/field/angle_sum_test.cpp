#include "field/angle_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::field {
namespace {

TEST(AngleSum, OfNothingIsZero) { EXPECT_EQ(AngleSum().value(), 0); }

TEST(AngleSum, AddsAnglesTimesTheirFactors) {
  AngleSum sum;
  sum.add(2 * unit(0.3), 1);
  sum.add(0.1 * unit(-0.5), 3);
  sum.add(unit(0.7), -2);
  sum.add(unit(1.5), 0);
  EXPECT_NEAR(sum.value(), 0.3 - 1.5 - 1.4, 1e-14);
}

TEST(AngleSum, CountsWholeTurnsInBothDirections) {
  for (const double angle : {1.4, -1.4, 0.01, -0.01, half_pi, -half_pi}) {
    AngleSum sum;
    for (int i = 1; i <= 1000; ++i) {
      sum.add(unit(angle), 1);
      ASSERT_NEAR(sum.value(), i * angle, 1e-12) << angle << " times " << i;
    }
    sum.add(unit(angle), -1000);
    EXPECT_NEAR(sum.value(), 0, 1e-12);
  }
}

TEST(AngleSum, NeitherOverflowsNorVanishes) {
  AngleSum sum;
  for (int i = 0; i < 500; ++i) sum.add(1e200 * unit(0.1), 1);
  for (int i = 0; i < 500; ++i) sum.add(1e-200 * unit(0.1), 1);
  EXPECT_NEAR(sum.value(), 100, 1e-11);
}

}  // namespace
}  // namespace quadrille::field
