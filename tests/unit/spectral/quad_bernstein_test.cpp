#include "spectral/quad_bernstein.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille::spectral {
namespace {

/// Value at (s, t) in the unit square.
double value(const BernsteinSquare& p, double s, double t) {
  const auto basis = [&](int i, double x) {
    return std::exp(std::lgamma(p.degree + 1) - std::lgamma(i + 1) - std::lgamma(p.degree - i + 1)) * std::pow(x, i) *
           std::pow(1 - x, p.degree - i);
  };
  double sum = 0;
  for (int j = 0; j <= p.degree; ++j)
    for (int i = 0; i <= p.degree; ++i) sum += p.coefs[j * (p.degree + 1) + i] * basis(i, s) * basis(j, t);
  return sum;
}

TEST(QuadBernstein, LeastValueOfAParabolaIsThatOfItsVertex) {
  // ((s - 1/3)^2 + (t - 3/4)^2) - 1 in degree 2.
  const std::array<double, 3> s{1.0 / 9, 1.0 / 9 - 1.0 / 3, 1.0 / 9 - 2.0 / 3 + 1};
  const std::array<double, 3> t{9.0 / 16, 9.0 / 16 - 3.0 / 4, 9.0 / 16 - 3.0 / 2 + 1};
  BernsteinSquare p{2, {}, 0};
  for (const double b : t)
    for (const double a : s) p.coefs.push_back(a + b - 1);
  for (const double tolerance : {1e-2, 1e-5, 1e-9}) {
    EXPECT_GE(least_value(p, tolerance), -1 - 1e-14);
    EXPECT_LE(least_value(p, tolerance), -1 + tolerance);
  }
}

TEST(QuadBernstein, LeastValueLiesBetweenTheCoefficientsAndDenseSamples) {
  for (int seed = 1; seed <= 20; ++seed) {
    BernsteinSquare p{5, {}, 0};
    for (int k = 0; k < 36; ++k) p.coefs.push_back(std::sin(seed * (k + 1) * 1.7));
    double sampled = 1e300;
    for (int j = 0; j <= 100; ++j)
      for (int i = 0; i <= 100; ++i) sampled = std::min(sampled, value(p, i / 100.0, j / 100.0));
    const double least = least_value(p, 1e-6);
    EXPECT_LE(least, sampled + 1e-6) << seed;
    EXPECT_GT(least, sampled - 5e-3) << seed << ": between samples it cannot be much less";
  }
}

TEST(QuadBernstein, LeastValueOfAConstantIsFoundAtOnce) {
  EXPECT_EQ(least_value({3, std::vector<double>(16, 0.7), 0}, 1e-300), 0.7);
}

}  // namespace
}  // namespace quadrille::spectral
