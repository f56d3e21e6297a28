#include "spectral/orthogonal_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {
namespace {

TEST(OrthogonalBasis, IsOrthonormalOnTheReferenceTriangle) {
  const int order = 20, n = num_tri_modes(order);
  const Quadrature along = gauss_legendre(order + 1), up = gauss_jacobi(order + 1, 1, 0);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd f(n);
  for (int i = 0; i <= order; ++i) {
    for (int j = 0; j <= order; ++j) {
      const double eta1 = along.points[i], eta2 = up.points[j];
      orthogonal_values(order, {(1 + eta1) * (1 - eta2) / 2 - 1, eta2}, f.data());
      mass += along.weights[i] * up.weights[j] / 2 * f * f.transpose();
    }
  }
  EXPECT_LT((mass - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(OrthogonalBasis, IsTheDubinerBasisSortedByDegree) {
  const int order = 7;
  std::vector<double> f(num_tri_modes(order));
  for (const Vec2 xi : {Vec2{-0.2, -0.3}, Vec2{-0.9, 0.7}, Vec2{0.3, -0.95}}) {
    orthogonal_values(order, xi, f.data());
    const double eta1 = 2 * (1 + xi.x) / (1 - xi.y) - 1;
    for (int d = 0; d <= order; ++d) {
      for (int p = 0; p <= d; ++p) {
        const int q = d - p;
        const double scale = std::sqrt((2 * p + 1) * (p + q + 1) / 2.0);
        const double expected =
            scale * jacobi(p, 0, 0, eta1) * std::pow((1 - xi.y) / 2, p) * jacobi(q, 2 * p + 1, 0, xi.y);
        EXPECT_NEAR(f[d * (d + 1) / 2 + p], expected, 1e-13);
      }
    }
  }
}

TEST(OrthogonalBasis, GradientsMatchFourthOrderDifferences) {
  const int order = 16, n = num_tri_modes(order);
  std::vector<double> f(n), f1(n), f2(n);
  const double step = 2e-4;
  const auto difference = [&](Vec2 xi, Vec2 direction, int mode) {
    const auto at = [&](double s) {
      std::vector<double> g(n);
      orthogonal_values(order, xi + s * step * direction, g.data());
      return g[mode];
    };
    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
  };
  for (const Vec2 xi : {Vec2{-1, 1}, Vec2{-0.2, -0.3}, Vec2{-0.5, 0.1}}) {
    orthogonal_gradients(order, xi, f.data(), f1.data(), f2.data());
    for (int mode = 0; mode < n; mode += 7) {
      EXPECT_NEAR(f1[mode], difference(xi, {1, 0}, mode), 1e-6 * (1 + std::abs(f1[mode])));
      EXPECT_NEAR(f2[mode], difference(xi, {0, 1}, mode), 1e-6 * (1 + std::abs(f2[mode])));
    }
  }
}

TEST(OrthogonalBasis, SumsAreTheProductsWithTheModes) {
  for (const int order : {0, 1, 2, 5, 16}) {
    const int n = num_tri_modes(order);
    std::vector<double> u(n), v(n), f(n), f1(n), f2(n);
    for (int i = 0; i < n; ++i) u[i] = 1.0 / (1 + i), v[i] = std::sin(i + 1.0);
    const Vec2 xi{-0.4, 0.1};
    orthogonal_gradients(order, xi, f.data(), f1.data(), f2.data());
    Vec2 value;
    Mat2 slope;
    for (int i = 0; i < n; ++i) {
      value = value + Vec2{u[i] * f[i], v[i] * f[i]};
      slope = {slope.xx + u[i] * f1[i], slope.xy + u[i] * f2[i], slope.yx + v[i] * f1[i], slope.yy + v[i] * f2[i]};
    }
    Mat2 gradient;
    const Vec2 both = orthogonal_sum(order, u.data(), v.data(), xi, gradient);
    const Vec2 only = orthogonal_sum(order, u.data(), v.data(), xi);
    EXPECT_EQ(both.x, only.x);
    EXPECT_EQ(both.y, only.y);
    EXPECT_NEAR(both.x, value.x, 1e-13);
    EXPECT_NEAR(both.y, value.y, 1e-13);
    EXPECT_NEAR(gradient.xx, slope.xx, 1e-11);
    EXPECT_NEAR(gradient.xy, slope.xy, 1e-11);
    EXPECT_NEAR(gradient.yx, slope.yx, 1e-11);
    EXPECT_NEAR(gradient.yy, slope.yy, 1e-11);
  }
}

TEST(OrthogonalBasis, RefusesOrdersBeyondItsTables) {
  std::vector<double> f(num_tri_modes(max_tri_order + 1));
  EXPECT_NO_THROW(orthogonal_values(max_tri_order, {0, 0}, f.data()));
  EXPECT_THROW(orthogonal_values(max_tri_order + 1, {0, 0}, f.data()), Defect);
}

}  // namespace
}  // namespace quadrille::spectral
