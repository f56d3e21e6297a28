#include "spectral/bernstein_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {
namespace {

TEST(Binomials, AreExactUpToTheDegreesOfDeterminants) {
  EXPECT_EQ(binomials(0), (std::vector<double>{1}));
  EXPECT_EQ(binomials(5), (std::vector<double>{1, 5, 10, 10, 5, 1}));
  const std::vector<double> row = binomials(39), above = binomials(38);
  for (int k = 1; k < 39; ++k) EXPECT_EQ(row[k], above[k - 1] + above[k]) << k;
}

/// Coefficients of x on [0, 1] are k / n; those of 1 are 1.
TEST(BernsteinTables, LinearFunctionsHaveLinearCoefficients) {
  for (const int n : {1, 2, 7, 20}) {
    const BernsteinTables& tables = bernstein_tables(n);
    for (int i = 0; i <= n; ++i) {
      long double one = 0, x = 0;
      for (int k = 0; k <= n; ++k) {
        one += tables.value[i * (n + 1) + k];
        x += tables.value[i * (n + 1) + k] * (1 + gll_points(n)[k]) / 2;
      }
      EXPECT_NEAR(static_cast<double>(one), 1, 1e-15 * tables.value_norm);
      EXPECT_NEAR(static_cast<double>(x), static_cast<double>(i) / n, 1e-15 * tables.value_norm);
    }
  }
}

/// The derivative by xi in [-1, 1] of xi^2 is 2 xi: coefficients -2 and 2.
TEST(BernsteinTables, DerivativesAreByTheReferenceCoordinate) {
  const BernsteinTables& tables = bernstein_tables(2);
  for (const int i : {0, 1}) {
    long double slope = 0;
    for (int k = 0; k <= 2; ++k) slope += tables.derivative[i * 3 + k] * gll_points(2)[k] * gll_points(2)[k];
    EXPECT_NEAR(static_cast<double>(slope), i == 0 ? -2 : 2, 1e-15);
  }
}

TEST(BernsteinTables, NormsAreTheGreatestSumsOfRows) {
  EXPECT_DOUBLE_EQ(bernstein_tables(1).value_norm, 1);
  EXPECT_DOUBLE_EQ(bernstein_tables(1).derivative_norm, 1) << "-1/2 and 1/2";
  EXPECT_DOUBLE_EQ(bernstein_tables(2).value_norm, 3) << "-1/2, 2, -1/2";
}

TEST(BernsteinTables, OrderZeroIsADefect) { EXPECT_THROW(bernstein_tables(0), Defect); }

/// (1 - x)^2 has the coefficients 1, 0, 0: its halves 1, 1/2, 1/4 and 1/4, 0, 0.
TEST(HalveLine, GivesTheCoefficientsOfBothHalves) {
  for (const int stride : {1, 3}) {
    std::vector<double> low(3 * stride, 7), high;
    for (int k = 0; k < 3; ++k) low[k * stride] = k == 0 ? 1 : 0;
    high = low;
    halve_line(low.data(), high.data(), 3, stride);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(low[k * stride], (std::vector<double>{1, 0.5, 0.25}[k]));
      EXPECT_EQ(high[k * stride], (std::vector<double>{0.25, 0, 0}[k]));
    }
    EXPECT_TRUE(stride == 1 || (low[1] == 7 && high[1] == 7)) << "lines beside it stay";
  }
}

}  // namespace
}  // namespace quadrille::spectral
