#include "curve/gauss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille::curve {
namespace {

double monomial_integral(int degree) { return degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0; }

template <int n>
void expect_exact_up_to_its_degree() {
  for (int degree = 0; degree < 2 * n; ++degree) {
    const auto f = [&](double x) { return std::pow(x, degree); };
    EXPECT_NEAR((gauss_integral<n>(f, -1.0, 1.0)), monomial_integral(degree), 1e-14) << degree;
  }
  // The next degree is integrated with an error of about 2^(1 - 2n).
  const auto f = [](double x) { return std::pow(x, 2 * n); };
  EXPECT_GT(std::abs(gauss_integral<n>(f, -1.0, 1.0) - monomial_integral(2 * n)), std::pow(2.0, -2 * n - 2));
}

TEST(Gauss, IsExactForPolynomialsUpToTwiceItsPoints) {
  expect_exact_up_to_its_degree<8>();
  expect_exact_up_to_its_degree<16>();
}

TEST(Gauss, PointsAreSymmetricAndAscend) {
  const GaussRule<8>& rule = gauss_rule<8>();
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(rule.points[i], -rule.points[7 - i], 1e-15);
  EXPECT_TRUE(std::is_sorted(rule.points.begin(), rule.points.end()));
  EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), 2, 1e-14);
}

TEST(Gauss, IntegratesFromAToB) {
  EXPECT_NEAR(gauss_integral([](double x) { return std::exp(x); }, 0.0, 2.0), std::exp(2.0) - 1, 1e-14);
  EXPECT_NEAR(gauss_integral([](double x) { return x; }, 3.0, 1.0), -4, 1e-14);
}

}  // namespace
}  // namespace quadrille::curve
