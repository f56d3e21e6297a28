#include "spectral/quad_map.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quad_bernstein.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {
namespace {

/// Values and derivatives of the nodal basis at equispaced sample points, ends included.
struct Samples {
  Eigen::MatrixXd value, derivative;

  explicit Samples(int order) {
    const int count = 2 * order + 3;
    std::vector<double> points(count);
    for (int i = 0; i < count; ++i) points[i] = -1 + 2.0 * i / (count - 1);
    value = interpolation_matrix(gll_points(order), points);
    derivative = value * differentiation_matrix(gll_points(order));
  }
};

const Samples& samples(int order) {
  static PerOrder<Samples> cache([](int n) { return Samples(n); });
  return cache[order];
}

}  // namespace

double quad_jacobian_lower_bound(int order, const Vec2* nodes, int depth) {
  return lower_bound(quad_jacobian_det(order, nodes), depth);
}

double quad_scaled_jacobian(int order, const Vec2* nodes) { return quad_scaled_jacobian_minimum(order, nodes).value; }

ScaledJacobianMinimum quad_scaled_jacobian_minimum(int order, const Vec2* nodes) {
  const Samples& s = samples(order);
  const int n = order + 1;
  Eigen::MatrixXd x(n, n), y(n, n);  // row: xi1, column: xi2
  for (int k = 0; k < n * n; ++k) {
    x.data()[k] = nodes[k].x - nodes[0].x;
    y.data()[k] = nodes[k].y - nodes[0].y;
  }
  const Eigen::MatrixXd x1 = s.derivative * x * s.value.transpose(), x2 = s.value * x * s.derivative.transpose();
  const Eigen::MatrixXd y1 = s.derivative * y * s.value.transpose(), y2 = s.value * y * s.derivative.transpose();
  ScaledJacobianMinimum least;
  for (Eigen::Index k = 0; k < x1.size(); ++k) {
    const Vec2 a{x1.data()[k], y1.data()[k]}, b{x2.data()[k], y2.data()[k]};
    const double det_j = cross(a, b), scale = std::sqrt(norm2(a) * norm2(b));
    const double value = scale > 0 ? det_j / scale : 0.0;
    const auto coordinate = [&](Eigen::Index i) {
      return -1 + 2 * static_cast<double>(i) / static_cast<double>(x1.rows() - 1);
    };
    if (k == 0 || value < least.value)
      least = {std::min(value, 1.0), {coordinate(k % x1.rows()), coordinate(k / x1.rows())}};
  }
  if (least.value <= 0) least.value = -1;
  return least;
}

Vec2 quad_position(int order, const Vec2* nodes, Vec2 xi) {
  const Eigen::MatrixXd basis = interpolation_matrix(gll_points(order), {xi.x, xi.y});
  Vec2 sum;
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= order; ++i) sum += basis(0, i) * basis(1, j) * nodes[j * (order + 1) + i];
  return sum;
}

}  // namespace quadrille::spectral
