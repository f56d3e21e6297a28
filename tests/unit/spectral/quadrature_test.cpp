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

TEST(Jacobi, LegendreAndChebyshevInClosedForm) {
  for (const double x : {-1.0, -0.37, 0.0, 0.5, 1.0}) {
    EXPECT_NEAR(jacobi(2, 0, 0, x), (3 * x * x - 1) / 2, 1e-15);
    EXPECT_NEAR(jacobi(3, 0, 0, x), (5 * x * x * x - 3 * x) / 2, 1e-15);
    EXPECT_NEAR(jacobi(1, 2, 1, x), 3 + 2.5 * (x - 1), 1e-15);
    // P_n^(-1/2, -1/2) is a multiple of cos(n arccos x).
    EXPECT_NEAR(jacobi(5, -0.5, -0.5, x), jacobi(5, -0.5, -0.5, 1) * std::cos(5 * std::acos(x)), 1e-14);
  }
}

TEST(Jacobi, ValueAtOneIsABinomial) {
  double binomial = 1;
  for (int n = 0; n <= 30; ++n) {
    EXPECT_NEAR(jacobi(n, 3, 0, 1) / binomial, 1, 1e-13);
    binomial *= (n + 4.0) / (n + 1.0);
  }
}

TEST(Jacobi, PolynomialsOfAllDegreesAreThoseOfEach) {
  const double x = 0.3;
  const std::vector<double> all = JacobiPolynomials(7, 3, 1).all(x);
  ASSERT_EQ(all.size(), 8U);
  for (int n = 0; n <= 7; ++n) {
    EXPECT_EQ(all[n], jacobi(n, 3, 1, x)) << n;
    EXPECT_EQ(all[n], JacobiPolynomials(n, 3, 1).last(x)) << n;
  }
  EXPECT_NEAR(all[2], 10 + 17.5 * (x - 1) + 7 * (x - 1) * (x - 1), 1e-13);
  EXPECT_EQ(JacobiPolynomials(-1, 0, 0).all(x), std::vector<double>{1});
}

TEST(Jacobi, DerivativeMatchesCentralDifferences) {
  const double step = 1e-5;
  for (int n = 0; n <= 9; ++n) {
    for (const double x : {-0.8, 0.1, 0.6}) {
      const double slope = (jacobi(n, 3, 1, x + step) - jacobi(n, 3, 1, x - step)) / (2 * step);
      EXPECT_NEAR(jacobi_derivative(n, 3, 1, x), slope, 1e-6 * (1 + std::abs(slope)));
    }
  }
}

}  // namespace

}  // namespace quadrille::spectral
