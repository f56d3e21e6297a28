#pragma once
// Sums of many angles: at the cost of one arc tangent each, since angles add where complex numbers multiply; and of the
// angles from many distant points at a cost that does not depend on their number, since each is the imaginary part of a
// complex logarithm, so that their sum has one power series in a disc that contains none of the points.

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/angle.hpp"
#include "base/vec2.hpp"

namespace quadrille {

/// Several sums of equally many terms. They are faster together than one after the other: no product waits for that of
/// another sum, and compilers use vector instructions.
class AngleSums {
 public:
  static constexpr int width = 8;  ///< number of sums
  using Values = std::array<double, width>;

  /// Adds `times` times the angle of (x[i], y[i]), which must be less than half a turn, to sum i.
  void add(const Values& x, Values y, int times) {
    if (times < 0)
      for (double& part : y) part = -part;
    for (int i = std::abs(times); i > 0; --i) multiply(x, y);
  }

  /// Sum i, radians; not reduced by whole turns.
  double value(int i) const { return 2 * pi * turns_[i] + (y_[i] == 0 && x_[i] < 0 ? pi : std::atan2(y_[i], x_[i])); }

 private:
  // The angle of (x_, y_) is in (-pi, pi]. It leaves this interval where both factors are above the real axis and the
  // product is below, or the other way round.
  void multiply(const Values& x, const Values& y) {
    for (int i = 0; i < width; ++i) {
      const double re = x_[i] * x[i] - y_[i] * y[i], im = x_[i] * y[i] + y_[i] * x[i];
      const double was_below = is_negative(y_[i]), is_below = is_negative(im);
      turns_[i] +=
          (1 - was_below) * is_negative(0.0 - y[i]) * is_below - was_below * is_negative(y[i]) * (1 - is_below);
      const double size = std::abs(re) + std::abs(im);
      x_[i] = re / size;
      y_[i] = im / size;
    }
  }

  // 1 or 0, without a branch. The sum turns -0 into 0.
  static double is_negative(double a) { return 0.5 - std::copysign(0.5, a + 0.0); }

  static constexpr Values filled(double value) {
    Values values{};
    values.fill(value);
    return values;
  }

  Values x_ = filled(1), y_{}, turns_{};
};

/// sum_j weight_j (arg(x - a_j) - arg(centre - a_j)) in the disc round `centre`, continuous there.
class AngleExpansion {
 public:
  AngleExpansion(Vec2 centre, double radius) : centre_(centre), radius_(radius) {}

  bool contains(Vec2 x) const { return norm2(x - centre_) <= radius_ * radius_; }
  /// Whether no point of the segment from a to b is so near that it slows down the convergence.
  bool is_far(Vec2 a, Vec2 b) const;
  /// Adds the angle from `a`, which must be far; the remainder of its series is below 1e-17 |weight|.
  void add(Vec2 a, Vec2 weight);
  /// The same sum in a disc that lies inside this one, less its value at the new centre.
  AngleExpansion inside(Vec2 centre, double radius) const;
  /// The sum at x, which must be in the disc.
  Vec2 at(Vec2 x) const;

 private:
  Vec2 centre_;
  double radius_;
  // Of each component of the weights, none if it is always 0: real and imaginary parts of the coefficients of (x -
  // centre)^k / radius^k, k > 0
  struct Series {
    std::vector<double> re, im;
    /// In powers of (x - other centre) / other radius; `offset` and `scale` are relative to this disc.
    Series about(Vec2 offset, double scale) const;
  };
  Series first_, second_;
};

}  // namespace quadrille
