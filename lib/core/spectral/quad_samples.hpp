#pragma once
// The sample points of scaled Jacobians: (2N + 3)^2, equispaced, ends included. Private to this folder.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/vec2.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

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

using Vector = Eigen::VectorXd;

/// Both derivatives of one coordinate at the samples of an element, xi1 fastest.
inline std::array<Vector, 2> sampled_derivatives(int order, const Vector& nodal) {
  const Samples& s = table_per_order<Samples>(order);
  const Eigen::Map<const Eigen::MatrixXd> x(nodal.data(), order + 1, order + 1);  // row: xi1, column: xi2
  const Eigen::MatrixXd x1 = s.derivative * x * s.value.transpose(), x2 = s.value * x * s.derivative.transpose();
  return {x1.reshaped(), x2.reshaped()};
}

/// The least of the values at the samples, not above 1, and where it is.
inline std::pair<double, Vec2> least_sample(const std::vector<double>& values) {
  const auto width = static_cast<std::ptrdiff_t>(std::lround(std::sqrt(static_cast<double>(values.size()))));
  const auto least = std::min_element(values.begin(), values.end());
  const std::ptrdiff_t k = least - values.begin();
  const auto coordinate = [&](std::ptrdiff_t i) {
    return -1 + 2 * static_cast<double>(i) / static_cast<double>(width - 1);
  };
  return {*least > 0 ? std::min(*least, 1.0) : -1, {coordinate(k % width), coordinate(k / width)}};
}

}  // namespace quadrille::spectral
