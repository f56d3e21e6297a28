#include "base/angle_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace quadrille
