#pragma once
// The size energy at one point of an element (refine/size_energy), and where the points of elements are.

#include <Eigen/Dense>
#include <array>
#include <limits>

#include "base/vec2.hpp"

namespace quadrille::refine {

/// The energy for a = x_s / h and b = x_t / h, and its derivatives by these; infinite if det J is not positive.
struct PointEnergy {
  PointEnergy(Vec2 a, Vec2 b, double weight);
  double value = 0;
  Vec2 by_a, by_b;
  /// Of the second derivatives: of mu^3 by mu and of mu by a and b; factors of the unit matrix, and of a a and b b.
  double mu_slope = 0, mu_bend = 0, size_a = 0, size_b = 0, turn_a = 0, turn_b = 0;
  Vec2 mu_a, mu_b;
};

inline PointEnergy::PointEnergy(Vec2 a, Vec2 b, double weight) {
  const double det = cross(a, b), aa = norm2(a), bb = norm2(b), mu = (aa + bb) / (2 * det);
  const double size = (aa * aa * aa + bb * bb * bb) / 2;
  const Vec2 det_a{b.y, -b.x}, det_b{-a.y, a.x};
  value = det > 0 ? size * det + weight * mu * mu * mu : std::numeric_limits<double>::infinity();
  mu_slope = 3 * weight * mu * mu / det;
  mu_bend = 6 * weight * mu;
  mu_a = (a - mu * det_a) / det, mu_b = (b - mu * det_b) / det;
  size_a = 3 * aa * aa * det, size_b = 3 * bb * bb * det;
  turn_a = 12 * aa * det, turn_b = 12 * bb * det;
  by_a = size_a * a + size * det_a + mu_slope * det * mu_a;
  by_b = size_b * b + size * det_b + mu_slope * det * mu_b;
}

/// The second derivatives by (a, b), with the absolute values of its curvatures: positive semidefinite.
Eigen::Matrix4d point_hessian(Vec2 a, Vec2 b, double weight);

struct SidePoint {
  int point = 0;  ///< s fastest
  bool is_along_a = true;
  double along = 1, across = 1;  ///< signs of the derivatives along the side and away from it
};

/// Of n x n points of an element: point p along a side, r away from it.
inline SidePoint side_point(int side, int p, int r, int n) {
  switch (side) {
    case 0:
      return {r * n + p, true, 1, 1};
    case 1:
      return {p * n + n - 1 - r, false, 1, -1};
    case 2:
      return {(n - 1 - r) * n + n - 1 - p, true, -1, -1};
    default:
      return {(n - 1 - p) * n + r, false, -1, 1};
  }
}

/// Derivatives by s and t of the bilinear functions of the corners.
inline std::array<Vec2, 4> corner_slopes(double s, double t) {
  return {{{t - 1, s - 1}, {1 - t, -s}, {t, s}, {-t, 1 - s}}};
}

}  // namespace quadrille::refine
