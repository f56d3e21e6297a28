#include "refine/skew_energy.hpp"

namespace quadrille::refine {

Eigen::Matrix4d skew_hessian(Vec2 a, Vec2 b, double weight) {
  using Eigen::Matrix4d, Eigen::Vector4d;
  const double aa = norm2(a), bb = norm2(b), det = cross(a, b), term = skewness(aa, bb, det, weight);
  const Vector4d along_a = Vector4d(a.x, a.y, 0, 0) / aa, along_b = Vector4d(0, 0, b.x, b.y) / bb;
  const Vector4d by_det = Vector4d(b.y, -b.x, -a.y, a.x) / det, by_log = along_a + along_b - by_det;
  Matrix4d sum = skew_power * by_log * by_log.transpose() + by_det * by_det.transpose() -
                 2 * (along_a * along_a.transpose() + along_b * along_b.transpose());
  sum.diagonal() += Vector4d(1 / aa, 1 / aa, 1 / bb, 1 / bb);
  sum(0, 3) -= 1 / det, sum(3, 0) -= 1 / det, sum(1, 2) += 1 / det, sum(2, 1) += 1 / det;
  return skew_power * term * sum;
}

}  // namespace quadrille::refine
