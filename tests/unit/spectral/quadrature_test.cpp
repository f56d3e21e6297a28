#include "spectral/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::spectral {
namespace {

double integrate_power(const Quadrature& rule, int k) {
  double sum = 0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) sum += rule.weights[i] * std::pow(rule.points[i], k);
  return sum;
}

double exact_power(int k) { return k % 2 == 0 ? 2.0 / (k + 1) : 0.0; }

TEST(Quadrature, GaussLegendreIsExactToTwiceTheCount) {
  for (int n = 1; n <= 32; ++n) {
    const Quadrature rule = gauss_legendre(n);
    for (int k = 0; k <= 2 * n - 1; ++k) EXPECT_NEAR(integrate_power(rule, k), exact_power(k), 1e-14) << n << " " << k;
  }
}

TEST(Quadrature, GaussJacobiIntegratesTheWeight) {
  // (1 - x) on [-1, 1]: the integral of (1 - x) x^k is 2 / (k + 1) for even and -2 / (k + 2) for odd k.
  for (int n = 1; n <= 24; ++n) {
    const Quadrature rule = gauss_jacobi(n, 1, 0);
    for (int k = 0; k <= 2 * n - 1; ++k) {
      const double exact = k % 2 == 0 ? 2.0 / (k + 1) : -2.0 / (k + 2);
      EXPECT_NEAR(integrate_power(rule, k), exact, 2e-14) << n << " " << k;
    }
  }
}

TEST(Quadrature, GaussLobattoIsExactAndHoldsTheEnds) {
  for (int n = 2; n <= 24; ++n) {
    const Quadrature rule = gauss_lobatto(n);
    EXPECT_EQ(rule.points.front(), -1);
    EXPECT_EQ(rule.points.back(), 1);
    for (int k = 0; k <= 2 * n - 3; ++k) EXPECT_NEAR(integrate_power(rule, k), exact_power(k), 1e-14) << n << " " << k;
  }
}

TEST(Quadrature, SmallLobattoRulesAreTheTextbookOnes) {
  const Quadrature four = gauss_lobatto(4);
  EXPECT_NEAR(four.points[1], -std::sqrt(0.2), 1e-16);
  EXPECT_NEAR(four.weights[0], 1.0 / 6, 1e-16);
  EXPECT_NEAR(four.weights[1], 5.0 / 6, 1e-15);
}

TEST(Quadrature, LegendreRulesAreSymmetricToTheLastBit) {
  for (int n = 2; n <= 30; ++n) {
    for (const Quadrature& rule : {gauss_legendre(n), gauss_lobatto(n)}) {
      for (int i = 0; i < n; ++i) {
        EXPECT_EQ(rule.points[i], -rule.points[n - 1 - i]);
        EXPECT_EQ(rule.weights[i], rule.weights[n - 1 - i]);
        EXPECT_LT(i > 0 ? rule.points[i - 1] : -2, rule.points[i]);
      }
    }
  }
}

TEST(Quadrature, GllPointsAreTheLobattoRule) {
  for (int order = 1; order <= 20; ++order) EXPECT_EQ(gll_points(order), gauss_lobatto(order + 1).points);
}

}  // namespace
}  // namespace quadrille::spectral
