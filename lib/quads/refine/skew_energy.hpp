#pragma once
// The term of the size energy that keeps the lines of an element across each other (refine/size_energy). With x the
// sine of the angle between x_s and x_t, the scaled Jacobian at a point,
//
//   w c (x^-12 - 1),    c = 0.8^12 = 0.069.
//
// mu^3 does not keep thin elements from shear: in a strip of height 1, mu of elements 10 long is 5.05, and 5.1 where
// the lines across lean by 45 degrees. This term is w at x = 0.8, 5 w at 0.7, 280 w at 0.5: so steep that forces
// between elements of very different lengths change x little. It is 0 for rectangles, whatever their sides.

#include <Eigen/Dense>
#include <array>

#include "refine/point_energy.hpp"

namespace quadrille::refine {

/// x that is good enough.
inline constexpr double good_sine = 0.8;
inline constexpr int skew_power = 12;

/// w c x^-12.
inline double skewness(double aa, double bb, double det, double weight) {
  const double ratio = good_sine * good_sine * aa * bb / (det * det), cube = ratio * ratio * ratio;
  return weight * cube * cube;
}

/// Adds the term to the energy at a point, of any a and b along x_s and x_t.
inline void add_skewness(Vec2 a, Vec2 b, double weight, PointEnergy& sum) {
  const double aa = a.x * a.x + a.y * a.y, bb = b.x * b.x + b.y * b.y;
  const double term = skewness(aa, bb, sum.det, weight), slope = skew_power * term;
  sum.value += term - skewness(1, 1, 1, weight);
  const double along_a = slope / aa, along_b = slope / bb, by_det = -slope / sum.det;
  sum.by_a.x += along_a * a.x + by_det * b.y, sum.by_a.y += along_a * a.y - by_det * b.x;
  sum.by_b.x += along_b * b.x - by_det * a.y, sum.by_b.y += along_b * b.y + by_det * a.x;
}

/// What is positive of the second derivatives, as PointBends::block.
std::array<double, 3> skew_block(Vec2 a, Vec2 b, double weight, double along_s, double along_t);

/// The second derivatives by (a, b).
Eigen::Matrix4d skew_hessian(Vec2 a, Vec2 b, double weight);

}  // namespace quadrille::refine
