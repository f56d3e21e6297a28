#include "galerkin/hole_winding.hpp"

#include <cmath>

namespace quadrille::galerkin {

namespace {

constexpr double tie_tol = 1e-6;

// The step a e_i + b e_j, j > i; b = 0: a step in one entry only.
struct Step {
  int i, j;
  double a, b;
};

// All steps of +-1 in one or two entries, in a fixed order.
std::vector<Step> steps(int size) {
  std::vector<Step> all;
  for (int i = 0; i < size; ++i) {
    for (const double a : {1.0, -1.0}) {
      all.push_back({i, i, a, 0});
      for (int j = i + 1; j < size; ++j) {
        for (const double b : {1.0, -1.0}) all.push_back({i, j, a, b});
      }
    }
  }
  return all;
}

}  // namespace

std::vector<int> nearest_hole_winding(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target) {
  const int size = static_cast<int>(target.size());
  Eigen::VectorXd m(size);
  for (int i = 0; i < size; ++i) m[i] = std::ceil(target[i] - 0.5 - tie_tol);

  const std::vector<Step> all = steps(size);
  Eigen::VectorXd slope = gram * (m - target);
  for (bool improved = true; improved;) {
    improved = false;
    for (const auto& [i, j, a, b] : all) {
      // |m + step - target|^2 - |m - target|^2 in the norm of the Gram matrix
      const double own = a * a * gram(i, i) + b * b * gram(j, j) + 2 * a * b * gram(i, j);
      if (2 * (a * slope[i] + b * slope[j]) + own >= -tie_tol * own) continue;
      m[i] += a;
      m[j] += b;
      slope = gram * (m - target);
      improved = true;
    }
  }
  std::vector<int> winding;
  for (const double x : m) winding.push_back(static_cast<int>(std::lround(x)));
  return winding;
}

}  // namespace quadrille::galerkin
