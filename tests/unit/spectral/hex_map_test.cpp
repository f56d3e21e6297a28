#include "spectral/hex_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/angle.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

using Map = std::function<Vec3(double, double, double)>;

std::vector<Vec3> sampled(int order, const Map& map) {
  std::vector<Vec3> nodes;
  const std::vector<double>& xi = gll_points(order);
  for (const double c : xi)
    for (const double b : xi)
      for (const double a : xi) nodes.push_back(map(a, b, c));
  return nodes;
}

/// Derivatives of the element at a point, from the one-dimensional Lagrange polynomials.
std::array<Vec3, 3> derivatives(int order, const std::vector<Vec3>& nodes, Vec3 at) {
  const Eigen::MatrixXd value = interpolation_matrix(gll_points(order), {at.x, at.y, at.z});
  const Eigen::MatrixXd slope = value * differentiation_matrix(gll_points(order));
  std::array<Vec3, 3> d{};
  const int n = order + 1;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vec3 x = nodes[(k * n + j) * n + i];
        d[0] += slope(0, i) * value(1, j) * value(2, k) * x;
        d[1] += value(0, i) * slope(1, j) * value(2, k) * x;
        d[2] += value(0, i) * value(1, j) * slope(2, k) * x;
      }
  return d;
}

double det(const std::array<Vec3, 3>& d) { return dot(d[0], cross(d[1], d[2])); }

double densely_sampled_det(int order, const std::vector<Vec3>& nodes, int count) {
  double least = 1e300;
  for (int k = 0; k <= count; ++k)
    for (int j = 0; j <= count; ++j)
      for (int i = 0; i <= count; ++i)
        least = std::min(
            least, det(derivatives(order, nodes, {-1 + 2.0 * i / count, -1 + 2.0 * j / count, -1 + 2.0 * k / count})));
  return least;
}

/// A quarter of a ring, revolved by 45 degrees.
Vec3 torus(double a, double b, double c) {
  const Vec2 in_plane = (1.5 + b / 2) * unit(pi / 4 * (1 - a));
  const double r = 4 + in_plane.x, angle = pi / 8 * (1 + c);
  return {r * std::cos(angle), in_plane.y, r * std::sin(angle)};
}
Vec3 wavy(double a, double b, double c) {
  return {a + 0.2 * std::sin(2 * b + c), b + 0.2 * std::cos(3 * c - a), c + 0.15 * std::sin(a + b)};
}
/// The angle between two of its edges is 4 degrees, and it is 1e-5 thin.
Vec3 skewed(double a, double b, double c) {
  return {a + 0.998 * b + 0.01 * a * b, 0.07 * b + 0.002 * a * a, 1e-5 * c * (1 + 0.1 * a) + 0.3 * a};
}
Vec3 folded(double a, double b, double c) { return {a + 0.7 * a * a, b, c}; }
/// Regular, but so distorted that the cheap bound fails: x' runs from 0.05 to 1.95.
Vec3 graded(double a, double b, double c) { return {a + 0.475 * a * a, b, c + 0.2 * b * c}; }

TEST(HexMap, BoundOfAnAffineElementIsItsDeterminant) {
  for (const int order : {1, 2, 4, 6, 8}) {
    const auto nodes = sampled(order, [](double a, double b, double c) {
      return Vec3{3 * a + b + 10, 2 * b - a, 1e-2 * c + 5 * a};
    });
    const double bound = hex_bounds(order, nodes.data()).jacobian;
    EXPECT_LE(bound, 0.07 * (1 + 1e-12)) << order;
    EXPECT_NEAR(bound, 0.07, 0.07 * (order <= 4 ? 1e-7 : 1e-3)) << order;
  }
}

TEST(HexMap, BoundsLieBelowDenseSamplesAndAboveZero) {
  for (const int order : {1, 2, 3, 4, 6, 8})
    for (const Map& map : {Map(torus), Map(wavy), Map(skewed), Map(graded)}) {
      if (order == 1 && map(1, 1, 1) == graded(1, 1, 1)) continue;
      const auto nodes = sampled(order, map);
      const double least = densely_sampled_det(order, nodes, 6);
      const HexBounds bounds = hex_bounds(order, nodes.data());
      EXPECT_GT(bounds.jacobian, 0) << order;
      EXPECT_LE(bounds.jacobian, least) << order;
    }
}

TEST(HexMap, DerivativesAreBounded) {
  const auto nodes = sampled(5, wavy);
  const HexBounds bounds = hex_bounds(5, nodes.data());
  for (const Vec3 at : {Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{-1, 0.5, 1}, Vec3{0.3, -1, -1}}) {
    const auto d = derivatives(5, nodes, at);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(norm(d[k]), bounds.derivatives[k]);
      EXPECT_GE(norm(d[k]), 0.1 * bounds.derivatives[k]);
    }
  }
}

TEST(HexMap, AFoldedElementIsNotProved) {
  for (const int order : {2, 3, 5}) {
    const auto nodes = sampled(order, folded);
    EXPECT_LE(hex_bounds(order, nodes.data()).jacobian, densely_sampled_det(order, nodes, 8)) << order;
    EXPECT_EQ(hex_scaled_jacobian(order, nodes.data()), -1) << order;
  }
}

TEST(HexMap, AReversedOrFlatElementIsNotProved) {
  const auto reversed = sampled(3, [](double a, double b, double c) { return Vec3{b, a, c}; });
  EXPECT_NEAR(hex_bounds(3, reversed.data()).jacobian, -1, 1e-9);
  const auto flat = sampled(2, [](double a, double b, double) { return Vec3{b, a, 0}; });
  EXPECT_LE(hex_bounds(2, flat.data()).jacobian, 0);
  const std::vector<Vec3> point(27, Vec3{1, 2, 3});
  EXPECT_LE(hex_bounds(2, point.data()).jacobian, 0);
}

TEST(HexMap, MovedNodesLowerTheBound) {
  auto nodes = sampled(4, torus);
  const HexBounds bounds = hex_bounds(4, nodes.data());
  const double moved = moved_jacobian_bound(4, bounds, 1e-6);
  EXPECT_LT(moved, bounds.jacobian);
  EXPECT_GT(moved, 0.9 * bounds.jacobian);
  double sign = 1;
  for (Vec3& x : nodes) x.y += (sign = -sign) * 1e-6;
  EXPECT_LE(moved, densely_sampled_det(4, nodes, 6));
}

TEST(HexMap, ScaledJacobianOfASkewedBoxIsItsVolume) {
  for (const int order : {1, 3}) {
    const auto nodes = sampled(order, [](double a, double b, double c) { return Vec3{2 * a + b, b, 5 * c}; });
    EXPECT_NEAR(hex_scaled_jacobian(order, nodes.data()), std::sqrt(0.5), 1e-12);
  }
}

}  // namespace

}  // namespace quadrille::spectral
