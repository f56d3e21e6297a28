#pragma once
// Symmetric 2 x 2 tensors: metrics, which measure lengths, their square roots and logarithms.

#include <cmath>

#include "base/vec2.hpp"

namespace quadrille {

struct SymmetricTensor {
  double xx = 1, xy = 0, yy = 1;  ///< the unit tensor

  constexpr SymmetricTensor& operator+=(const SymmetricTensor& b) { return xx += b.xx, xy += b.xy, yy += b.yy, *this; }
  constexpr bool operator==(const SymmetricTensor&) const = default;
};

constexpr SymmetricTensor operator*(double s, const SymmetricTensor& t) { return {s * t.xx, s * t.xy, s * t.yy}; }
constexpr Vec2 operator*(const SymmetricTensor& t, Vec2 a) {
  return {t.xx * a.x + t.xy * a.y, t.xy * a.x + t.yy * a.y};
}
/// det(t) must not be 0.
constexpr SymmetricTensor inverse(const SymmetricTensor& t) {
  return 1 / (t.xx * t.yy - t.xy * t.xy) * SymmetricTensor{t.yy, -t.xy, t.xx};
}
constexpr double det(const SymmetricTensor& t) { return t.xx * t.yy - t.xy * t.xy; }

/// Eigenvalues, and the angle of the first one's direction (radians).
struct EigenPair {
  double first = 1, second = 1, angle = 0;
};

/// `first` is the greater one.
inline EigenPair eigen_pair(const SymmetricTensor& t) {
  const double mean = (t.xx + t.yy) / 2, radius = std::hypot((t.xx - t.yy) / 2, t.xy);
  return {mean + radius, mean - radius, std::atan2(2 * t.xy, t.xx - t.yy) / 2};
}

inline SymmetricTensor tensor_of(const EigenPair& of) {
  const Vec2 double_angle = unit(2 * of.angle);
  const double mean = (of.first + of.second) / 2, radius = (of.first - of.second) / 2;
  return {mean + radius * double_angle.x, radius * double_angle.y, mean - radius * double_angle.x};
}

}  // namespace quadrille
