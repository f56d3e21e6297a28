#pragma once
// A sum of many angles at the cost of one arc tangent: angles add where complex numbers multiply.

#include <cmath>
#include <cstdlib>

#include "base/angle.hpp"
#include "base/vec2.hpp"

namespace quadrille::field {

class AngleSum {
 public:
  /// Adds `times` times the angle of z, which must be less than half a turn.
  void add(Vec2 z, int times) {
    if (times < 0) z.y = -z.y;
    for (int i = std::abs(times); i > 0; --i) multiply(z);
  }

  /// Radians; not reduced by whole turns.
  double value() const { return 2 * pi * turns_ + (z_.y == 0 && z_.x < 0 ? pi : angle_of(z_)); }

 private:
  // The angle of z_ is in (-pi, pi]. It leaves this interval where both factors are above the real axis and the product
  // is below, or the other way round.
  void multiply(Vec2 factor) {
    const Vec2 z = {z_.x * factor.x - z_.y * factor.y, z_.x * factor.y + z_.y * factor.x};
    if (z_.y >= 0 && factor.y > 0 && z.y < 0) ++turns_;
    if (z_.y < 0 && factor.y < 0 && z.y >= 0) --turns_;
    z_ = z / (std::abs(z.x) + std::abs(z.y));
  }

  Vec2 z_{1, 0};
  int turns_ = 0;
};

}  // namespace quadrille::field
