#include "spectral/lagrange.hpp"

namespace quadrille::spectral {

namespace {

// Differences are scaled by 2 (the length of [-1, 1] over its capacity) so that products of many of them stay near 1.
std::vector<double> barycentric_weights(const std::vector<double>& points) {
  std::vector<double> weights(points.size(), 1.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i) weights[i] /= 2 * (points[i] - points[j]);
    }
  }
  return weights;
}

}  // namespace

Eigen::MatrixXd interpolation_matrix(const std::vector<double>& from, const std::vector<double>& to) {
  const std::vector<double> weights = barycentric_weights(from);
  const int rows = static_cast<int>(to.size()), cols = static_cast<int>(from.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, cols);
  for (int i = 0; i < rows; ++i) {
    int hit = -1;
    for (int j = 0; j < cols; ++j) {
      if (to[i] == from[j]) hit = j;
    }
    if (hit >= 0) {
      matrix(i, hit) = 1;
      continue;
    }
    for (int j = 0; j < cols; ++j) matrix(i, j) = weights[j] / (to[i] - from[j]);
    matrix.row(i) /= matrix.row(i).sum();
  }
  return matrix;
}

Eigen::MatrixXd differentiation_matrix(const std::vector<double>& points) {
  const std::vector<double> weights = barycentric_weights(points);
  const int n = static_cast<int>(points.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (j == i) continue;
      matrix(i, j) = weights[j] / weights[i] / (points[i] - points[j]);
      matrix(i, i) -= matrix(i, j);  // rows sum to 0, the derivative of a constant
    }
  }
  return matrix;
}

}  // namespace quadrille::spectral
