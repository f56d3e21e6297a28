#include "galerkin/hole_winding.hpp"

#include "base/tolerance.hpp"

namespace quadrille::galerkin {

std::vector<int> nearest_hole_winding(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target) {
  Eigen::VectorXd m = (target.array() - 0.5 - tolerance::tied).ceil();
  Eigen::VectorXd slope = gram * (m - target);
  const auto size = m.size();
  // Takes the step a e_i + b e_j (b = 0: in one entry only) if it reduces |m - target| in the norm of the Gram matrix.
  const auto take = [&](Eigen::Index i, double a, Eigen::Index j, double b) {
    const double own = a * a * gram(i, i) + b * b * gram(j, j) + 2 * a * b * gram(i, j);
    if (2 * (a * slope[i] + b * slope[j]) + own >= -tolerance::tied * own) return false;
    m[i] += a;
    m[j] += b;
    slope += a * gram.col(i) + b * gram.col(j);
    return true;
  };
  // All steps in a fixed order, until none reduces the norm.
  for (bool is_improved = true; is_improved;) {
    is_improved = false;
    for (Eigen::Index i = 0; i < size; ++i)
      for (const double a : {1.0, -1.0}) {
        is_improved |= take(i, a, i, 0);
        for (Eigen::Index j = i + 1; j < size; ++j)
          for (const double b : {1.0, -1.0}) is_improved |= take(i, a, j, b);
      }
  }
  const Eigen::VectorXi winding = m.cast<int>();
  return {winding.begin(), winding.end()};
}

}  // namespace quadrille::galerkin
