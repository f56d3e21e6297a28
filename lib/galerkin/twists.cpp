#include "galerkin/twists.hpp"

#include <cmath>

namespace quadrille {

namespace {

constexpr double tie_tol = 1e-6;

// All steps by one in one or two entries, in a fixed sequence.
std::vector<Eigen::VectorXd> steps(int size) {
  std::vector<Eigen::VectorXd> all;
  for (int i = 0; i < size; ++i) {
    for (const double a : {1.0, -1.0}) {
      const Eigen::VectorXd step = a * Eigen::VectorXd::Unit(size, i);
      all.push_back(step);
      for (int j = i + 1; j < size; ++j) {
        for (const double b : {1.0, -1.0}) all.emplace_back(step + b * Eigen::VectorXd::Unit(size, j));
      }
    }
  }
  return all;
}

}  // namespace

std::vector<int> nearest_twists(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target) {
  const int size = static_cast<int>(target.size());
  Eigen::VectorXd m(size);
  for (int i = 0; i < size; ++i) m[i] = std::ceil(target[i] - 0.5 - tie_tol);

  const std::vector<Eigen::VectorXd> all = steps(size);
  for (bool improved = true; improved;) {
    improved = false;
    for (const Eigen::VectorXd& step : all) {
      // |m + step - target|^2 - |m - target|^2 in the norm of the Gram matrix
      const double own = step.dot(gram * step);
      if (2 * step.dot(gram * (m - target)) + own >= -tie_tol * own) continue;
      m += step;
      improved = true;
    }
  }
  std::vector<int> twists;
  for (const double x : m) twists.push_back(static_cast<int>(std::lround(x)));
  return twists;
}

}  // namespace quadrille
