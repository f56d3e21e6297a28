#include "refine/point_energy.hpp"

namespace quadrille::refine {
namespace {

using Eigen::Matrix2d, Eigen::Matrix4d, Eigen::Vector2d, Eigen::Vector4d;

Matrix4d symmetric_product(const Vector4d& u, const Vector4d& v) { return u * v.transpose() + v * u.transpose(); }

/// Half the second derivatives of |a|^8.
Matrix2d size_bend(const Vector2d& a) {
  const double aa = a.squaredNorm();
  return 4 * aa * aa * (aa * Matrix2d::Identity() + 6 * a * a.transpose());
}

}  // namespace

Matrix4d point_hessian(Vec2 a, Vec2 b, double weight, const Matrix4d& more) {
  const double det = cross(a, b), aa = norm2(a), bb = norm2(b), mu = (aa + bb) / (2 * det);
  const double aaa = aa * aa * aa, bbb = bb * bb * bb, size = (aaa * aa + bbb * bb) / 2;
  const Vector4d x(a.x, a.y, b.x, b.y), det_x(b.y, -b.x, -a.y, a.x), mu_x = (x - mu * det_x) / det;
  const Vector4d size_x = 4 * Vector4d(aaa * a.x, aaa * a.y, bbb * b.x, bbb * b.y);
  Matrix4d det_xx = Matrix4d::Zero(), size_xx = Matrix4d::Zero();
  det_xx(0, 3) = det_xx(3, 0) = 1, det_xx(1, 2) = det_xx(2, 1) = -1;
  size_xx.topLeftCorner<2, 2>() = size_bend(x.head<2>());
  size_xx.bottomRightCorner<2, 2>() = size_bend(x.tail<2>());
  const Matrix4d mu_xx = (Matrix4d::Identity() - symmetric_product(mu_x, det_x) - mu * det_xx) / det;
  Matrix4d sum = det * size_xx + symmetric_product(size_x, det_x) + size * det_xx +
                 3 * weight * mu * (mu * mu_xx + 2 * mu_x * mu_x.transpose());
  sum += more;
  if (sum.llt().info() == Eigen::Success) return sum;
  const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(sum);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseAbs().asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace quadrille::refine
