#include "spectral/lagrange.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "spectral/quadrature.hpp"

namespace quadrille::spectral {
namespace {

TEST(Lagrange, InterpolatesPolynomialsExactly) {
  for (int order = 1; order <= 20; ++order) {
    const std::vector<double>& from = gll_points(order);
    const std::vector<double> to{-1, -0.73, from[order / 2], 0.2, 0.999, 1};
    const Eigen::MatrixXd matrix = interpolation_matrix(from, to);
    for (std::size_t i = 0; i < to.size(); ++i) {
      double sum = 0;
      for (int j = 0; j <= order; ++j) sum += matrix(i, j) * std::pow(from[j], order);
      EXPECT_NEAR(sum, std::pow(to[i], order), 2e-15);
      EXPECT_NEAR(matrix.row(i).sum(), 1, 1e-14);
    }
  }
}

TEST(Lagrange, DifferentiatesPolynomialsExactly) {
  for (int order = 1; order <= 16; ++order) {
    const std::vector<double>& points = gll_points(order);
    const Eigen::MatrixXd matrix = differentiation_matrix(points);
    for (int i = 0; i <= order; ++i) {
      double sum = 0;
      for (int j = 0; j <= order; ++j) sum += matrix(i, j) * std::pow(points[j], order);
      EXPECT_NEAR(sum, order * std::pow(points[i], order - 1), 1e-12);
    }
  }
}

}  // namespace
}  // namespace quadrille::spectral
