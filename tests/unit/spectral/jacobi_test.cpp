#include "spectral/jacobi.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::spectral {
namespace {

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
