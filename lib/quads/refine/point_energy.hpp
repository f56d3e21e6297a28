#pragma once
// The size energy at one point of an element (refine/size_energy), and where the points of elements are.

#include <Eigen/Dense>
#include <array>
#include <type_traits>

#include "base/vec2.hpp"

namespace quadrille::refine {

/// The energy for a = x_s / h and b = x_t / h, and its derivatives by these, where det J is positive.
struct PointEnergy {
  PointEnergy(Vec2 a, Vec2 b, double weight);
  double det, value;
  Vec2 by_a, by_b;
};

/// In the header, so that loops over points are compiled for several at once.
inline PointEnergy::PointEnergy(Vec2 a, Vec2 b, double weight) : det(a.x * b.y - a.y * b.x) {
  const double aa = a.x * a.x + a.y * a.y, bb = b.x * b.x + b.y * b.y, mu = 0.5 * (aa + bb) / det;
  const double aaa = aa * aa * aa, bbb = bb * bb * bb, size = 0.5 * (aaa * aa + bbb * bb), mu_mu = weight * mu * mu;
  value = size * det + mu_mu * mu;
  // mu grows by (a - mu det_a) / det with a, det_a = (b_y, -b_x), and with b alike, det_b = (-a_y, a_x).
  const double mu_slope = 3.0 * mu_mu / det, by_det = size - mu_slope * mu;
  const double along_a = 4.0 * aaa * det + mu_slope, along_b = 4.0 * bbb * det + mu_slope;
  by_a = {along_a * a.x + by_det * b.y, along_a * a.y - by_det * b.x};
  by_b = {along_b * b.x - by_det * a.y, along_b * b.y + by_det * a.x};
}

/// What is positive of the second derivatives.
class PointBends {
 public:
  PointBends(Vec2 a, Vec2 b, double weight);
  /// (xx, xy, yy), by the move of a point with which a moves by `along_s` and b by `along_t`.
  std::array<double, 3> block(double along_s, double along_t) const;

 private:
  Vec2 a_, b_;
  /// Of mu^3 by mu and of mu by a and b; factors of the unit matrix, and of a a and b b.
  double mu_slope_, mu_bend_, size_a_, size_b_, turn_a_, turn_b_;
  Vec2 mu_a_, mu_b_;
};

inline PointBends::PointBends(Vec2 a, Vec2 b, double weight) : a_(a), b_(b) {
  const double det = cross(a, b), aa = norm2(a), bb = norm2(b), mu = (aa + bb) / (2 * det);
  mu_slope_ = 3 * weight * mu * mu / det;
  mu_bend_ = 6 * weight * mu;
  mu_a_ = (a - mu * Vec2{b.y, -b.x}) / det, mu_b_ = (b - mu * Vec2{-a.y, a.x}) / det;
  turn_a_ = 24 * aa * aa * det, turn_b_ = 24 * bb * bb * det;
  size_a_ = turn_a_ * aa / 6, size_b_ = turn_b_ * bb / 6;
}

inline std::array<double, 3> PointBends::block(double along_s, double along_t) const {
  const double ss = along_s * along_s, tt = along_t * along_t;
  const Vec2 g = along_s * mu_a_ + along_t * mu_b_;
  const double round = mu_slope_ * (ss + tt) + size_a_ * ss + size_b_ * tt, turn_a = turn_a_ * ss,
               turn_b = turn_b_ * tt;
  return {round + mu_bend_ * g.x * g.x + turn_a * a_.x * a_.x + turn_b * b_.x * b_.x,
          mu_bend_ * g.x * g.y + turn_a * a_.x * a_.y + turn_b * b_.x * b_.y,
          round + mu_bend_ * g.y * g.y + turn_a * a_.y * a_.y + turn_b * b_.y * b_.y};
}

/// The second derivatives by (a, b) and `more`, those of other terms, with the absolute values of their curvatures:
/// positive semidefinite.
Eigen::Matrix4d point_hessian(Vec2 a, Vec2 b, double weight, const Eigen::Matrix4d& more);

/// Where the points of an element are as seen from a side: p along it, r away from it.
struct SideFrame {
  int first = 0, step_along = 0, step_across = 0;
  double along = 1, across = 1;  ///< signs of the derivatives along the side and away from it

  int point(int p, int r) const { return first + p * step_along + r * step_across; }
};

/// Of n x n points, s fastest.
constexpr SideFrame side_frame(int side, int n) {
  switch (side) {
    case 0:
      return {0, 1, n, 1, 1};
    case 1:
      return {n - 1, n, -1, 1, -1};
    case 2:
      return {n * n - 1, -1, -n, -1, -1};
    default:
      return {n * (n - 1), -n, 1, -1, 1};
  }
}

/// visit(std::integral_constant<int, side>): loops over the points of a known side are fast.
template <int first = 0, class Visit>
void with_side(int side, const Visit& visit) {
  if constexpr (first < 4)
    side == first ? visit(std::integral_constant<int, first>{}) : with_side<first + 1>(side, visit);
}

/// Derivatives by s and t of the bilinear functions of the corners.
inline std::array<Vec2, 4> corner_slopes(double s, double t) {
  return {{{t - 1, s - 1}, {1 - t, -s}, {t, s}, {-t, 1 - s}}};
}

}  // namespace quadrille::refine
