#include "galerkin/hole_winding.hpp"

#include <cmath>
#include <utility>

namespace quadrille::galerkin {

namespace {

constexpr double tie_tol = 1e-6;

// The step a e_i + b e_j, j > i; b = 0: a step in one entry only.
struct Step {
  int i, j;
  double a, b;
};

/// Goes from an integer vector to nearer ones by steps of +-1 in one or two entries.
class Descent {
 public:
  Descent(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target, Eigen::VectorXd start)
      : gram_(gram), m_(std::move(start)), slope_(gram * (m_ - target)) {}

  /// Takes every step that reduces the norm, in a fixed order; returns whether there was one.
  bool improve() {
    bool improved = false;
    const int size = static_cast<int>(m_.size());
    for (int i = 0; i < size; ++i) {
      for (const double a : {1.0, -1.0}) {
        improved = take({i, i, a, 0}) || improved;
        for (int j = i + 1; j < size; ++j) {
          for (const double b : {1.0, -1.0}) improved = take({i, j, a, b}) || improved;
        }
      }
    }
    return improved;
  }

  const Eigen::VectorXd& position() const { return m_; }

 private:
  bool take(const Step& step) {
    const auto& [i, j, a, b] = step;
    // |m + step - target|^2 - |m - target|^2 in the norm of the Gram matrix
    const double own = a * a * gram_(i, i) + b * b * gram_(j, j) + 2 * a * b * gram_(i, j);
    if (2 * (a * slope_[i] + b * slope_[j]) + own >= -tie_tol * own) return false;
    m_[i] += a;
    m_[j] += b;
    slope_ += a * gram_.col(i) + b * gram_.col(j);
    return true;
  }

  const Eigen::MatrixXd& gram_;
  Eigen::VectorXd m_, slope_;  ///< slope: gram (m - target)
};

}  // namespace

std::vector<int> nearest_hole_winding(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target) {
  Eigen::VectorXd rounded(target.size());
  for (Eigen::Index i = 0; i < target.size(); ++i) rounded[i] = std::ceil(target[i] - 0.5 - tie_tol);
  Descent descent(gram, target, std::move(rounded));
  while (descent.improve()) continue;
  std::vector<int> winding;
  for (const double x : descent.position()) winding.push_back(static_cast<int>(std::lround(x)));
  return winding;
}

}  // namespace quadrille::galerkin
