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

/// What is positive of the second derivatives. Of the logarithm of the term, 12 (ln |a| + ln |b| - ln det J), the
/// curvatures along a and b are negative.
class SkewBends {
 public:
  SkewBends(Vec2 a, Vec2 b, double weight);
  /// As PointBends::block.
  std::array<double, 3> block(double along_s, double along_t) const;

 private:
  Vec2 a_, b_;
  double aa_, bb_, det_, term_;
};

inline SkewBends::SkewBends(Vec2 a, Vec2 b, double weight)
    : a_(a), b_(b), aa_(norm2(a)), bb_(norm2(b)), det_(cross(a, b)), term_(skewness(aa_, bb_, det_, weight)) {}

inline std::array<double, 3> SkewBends::block(double along_s, double along_t) const {
  const Vec2 by_det = (along_s * Vec2{b_.y, -b_.x} + along_t * Vec2{-a_.y, a_.x}) / det_;
  const Vec2 by_log = (along_s / aa_) * a_ + (along_t / bb_) * b_ - by_det;
  const Vec2 across_a = (along_s / aa_) * Vec2{-a_.y, a_.x}, across_b = (along_t / bb_) * Vec2{-b_.y, b_.x};
  const double steep = skew_power * skew_power * term_, flat = skew_power * term_;
  const auto sum = [&](double u, double v, double du, double dv, double au, double av, double bu, double bv) {
    return steep * u * v + flat * du * dv + flat * au * av + flat * bu * bv;
  };
  return {sum(by_log.x, by_log.x, by_det.x, by_det.x, across_a.x, across_a.x, across_b.x, across_b.x),
          sum(by_log.x, by_log.y, by_det.x, by_det.y, across_a.x, across_a.y, across_b.x, across_b.y),
          sum(by_log.y, by_log.y, by_det.y, by_det.y, across_a.y, across_a.y, across_b.y, across_b.y)};
}

/// The second derivatives by (a, b).
Eigen::Matrix4d skew_hessian(Vec2 a, Vec2 b, double weight);

}  // namespace quadrille::refine
