#include "spectral/quad_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "quad_samples.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

/// Least det J on a dense grid, from derivatives of the interpolant.
double densely_sampled_det(int order, const std::vector<Vec2>& nodes, int count) {
  const int n = order + 1;
  std::vector<double> points;
  for (int i = 0; i <= count; ++i) points.push_back(-1 + 2.0 * i / count);
  const Eigen::MatrixXd value = interpolation_matrix(gll_points(order), points);
  const Eigen::MatrixXd slope = value * differentiation_matrix(gll_points(order));
  Eigen::MatrixXd x(n, n), y(n, n);
  for (int k = 0; k < n * n; ++k) x.data()[k] = nodes[k].x, y.data()[k] = nodes[k].y;
  const Eigen::MatrixXd det = (slope * x * value.transpose()).cwiseProduct(value * y * slope.transpose()) -
                              (value * x * slope.transpose()).cwiseProduct(slope * y * value.transpose());
  return det.minCoeff();
}

Vec2 ring(double a, double b) { return (1.5 + b / 2) * unit(pi / 4 * (1 - a)); }
Vec2 wavy(double a, double b) { return {a + 0.2 * std::sin(2 * b + a), b + 0.2 * std::cos(3 * a - b)}; }

TEST(QuadMap, BoundOfAnAffineElementIsItsDeterminant) {
  for (const int order : {1, 2, 4, 8, 13, 20}) {
    const auto nodes = sampled(order, [](double a, double b) { return Vec2{3 * a + b, 2 * b - a}; });
    const double bound = quad_jacobian_lower_bound(order, nodes.data());
    // What is proved of rounding grows with the condition of the Bernstein basis, 5e11 at degree 20 in two variables.
    EXPECT_LE(bound, 7) << order;
    EXPECT_NEAR(bound, 7, order <= 8 ? 1e-9 : 1e-2) << order;
  }
}

TEST(QuadMap, BoundLiesBelowDenseSamplesAndAboveZero) {
  for (const int order : {2, 3, 4, 6, 8, 10, 15, 20})
    for (const Map& map : {Map(ring), Map(wavy)}) {
      const auto nodes = sampled(order, map);
      const double least = densely_sampled_det(order, nodes, 60);
      const double bound = quad_jacobian_lower_bound(order, nodes.data());
      ASSERT_GT(least, 0);
      EXPECT_GT(bound, 0) << order;
      EXPECT_LE(bound, least) << order;
    }
}

TEST(QuadMap, BoundTendsToTheLeastValueUnderSubdivision) {
  // det J = 1 + xi1 + 0.01 times a constant: least value 0.01 at xi1 = -1.
  const auto nodes = sampled(4, [](double a, double b) { return Vec2{a + a * a / 2 + 0.01 * a, b}; });
  const double bound = quad_jacobian_lower_bound(4, nodes.data());
  EXPECT_NEAR(bound, 0.01, 1e-12);
  EXPECT_LE(bound, 0.01);
}

TEST(QuadMap, InvertedElementsAreNeverPositive) {
  for (const int order : {1, 4, 9, 20}) {
    const auto mirrored = sampled(order, [](double a, double b) { return Vec2{-a, b}; });
    EXPECT_LE(quad_jacobian_lower_bound(order, mirrored.data()), -1);
    const auto folded = sampled(order, [](double a, double b) { return Vec2{a * (a + 1.5), b}; });
    if (order > 1) {
      EXPECT_LE(quad_jacobian_lower_bound(order, folded.data()), -0.5);
      EXPECT_EQ(quad_scaled_jacobian(order, folded.data()), -1);
    }
  }
}

TEST(QuadMap, ZeroDeterminantInACornerIsNotPositive) {
  // Bilinear with three corners on one line: det J = 0 in the middle one.
  const std::vector<Vec2> corners{{0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}};
  EXPECT_LE(quad_jacobian_lower_bound(1, corners.data(), 8), 0);
  const auto blend = [&](double a, double b) {
    const double s = (1 + a) / 2, t = (1 + b) / 2;
    return (1 - s) * (1 - t) * corners[0] + s * (1 - t) * corners[1] + s * t * corners[2] + (1 - s) * t * corners[3];
  };
  for (const int order : {2, 5, 12, 20})
    EXPECT_LE(quad_jacobian_lower_bound(order, sampled(order, blend).data(), 6), 0) << order;
}

TEST(QuadMap, BoundScalesWithTheAreaAndIgnoresTheOrigin) {
  const auto nodes = sampled(5, ring);
  const auto moved = sampled(5, [](double a, double b) { return Vec2{1e6, -1e6} + ring(a, b); });
  const auto shrunk = sampled(5, [](double a, double b) { return 1e-6 * ring(a, b); });
  const double bound = quad_jacobian_lower_bound(5, nodes.data());
  EXPECT_NEAR(quad_jacobian_lower_bound(5, moved.data()), bound, 1e-7);
  EXPECT_NEAR(quad_jacobian_lower_bound(5, shrunk.data()), 1e-12 * bound, 1e-24);
}

TEST(QuadMap, ThinElementsOfHighOrderAreProved) {
  for (const int order : {10, 16, 20}) {
    const auto nodes = sampled(order, [](double a, double b) { return (1 + 0.005 * b) * unit(-a / 2); });
    EXPECT_GT(quad_jacobian_lower_bound(order, nodes.data()), 0) << order;
  }
}

/// Nodes that are rounded lie beside the bilinear map: what is proved is that of the polynomial through them.
TEST(QuadMap, BoundOfARoundedBilinearElementLiesBelowItsPolynomial) {
  for (const int order : {1, 2, 4, 7})
    for (const Vec2 origin : {Vec2{}, Vec2{3e3, -1e3}}) {
      const auto nodes = sampled(order, [&](double a, double b) {
        return origin + Vec2{a + 0.2 * b + 0.3 * a * b, b - 0.1 * a - 0.2 * a * b};
      });
      const double bound = quad_jacobian_lower_bound(order, nodes.data());
      const BernsteinSquare det = quad_jacobian_det(order, nodes.data());
      EXPECT_LE(bound, *std::ranges::min_element(det.coefs) + det.error) << order;
      EXPECT_NEAR(bound, *std::ranges::min_element(det.coefs), 1e-7) << order;
      const ScaledJacobianMinimum least = quad_scaled_jacobian_minimum(order, nodes.data());
      EXPECT_EQ(std::abs(least.xi.x) * std::abs(least.xi.y), 1);
    }
}

TEST(QuadMap, ScaledJacobianIsTheSineOfTheAngle) {
  const auto sheared = sampled(3, [](double a, double b) { return Vec2{5 * (a + b), b}; });
  EXPECT_NEAR(quad_scaled_jacobian(3, sheared.data()), 1 / std::sqrt(26.0), 1e-14);
  EXPECT_NEAR(quad_scaled_jacobian(8, sampled(8, ring).data()), 1, 1e-6);
}

TEST(QuadMap, PositionReproducesTheMap) {
  const auto cubic = [](double a, double b) { return Vec2{a * a * a - b, a * b * b}; };
  const auto nodes = sampled(4, cubic);
  const Vec2 x = quad_position(4, nodes.data(), {0.3, -0.7});
  EXPECT_NEAR(distance(x, cubic(0.3, -0.7)), 0, 1e-14);
  EXPECT_EQ(quad_position(4, nodes.data(), {1, -1}), nodes[4]);
}

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
