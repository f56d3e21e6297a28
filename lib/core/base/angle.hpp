#pragma once
// Arithmetic of angles and crosses. Angles are in radians, counter-clockwise.
// A cross is unchanged by quarter turns: C(psi) = { psi + k pi/2 } (paper, eq. 1).

#include <cmath>
#include <numbers>

#include "base/vec2.hpp"

namespace quadrille {

inline constexpr double pi = std::numbers::pi;
inline constexpr double half_pi = pi / 2;

inline constexpr double degrees(double radians) { return radians * (180.0 / pi); }
inline constexpr double radians(double degrees) { return degrees * (pi / 180.0); }

/// `angle` wrapped into (-pi, pi].
inline double wrap_pi(double angle) {
  const double r = std::remainder(angle, 2 * pi);
  return r <= -pi ? r + 2 * pi : r;
}

/// `angle` wrapped into [0, 2 pi).
inline double wrap_two_pi(double angle) {
  const double r = angle - 2 * pi * std::floor(angle / (2 * pi));
  return r >= 2 * pi ? 0.0 : r;
}

/// The guiding field's value for a boundary tangent of angle `theta` (paper, eq. 3): (cos 4 theta, sin 4 theta).
inline Vec2 cross_value(double theta) { return unit(4 * theta); }

/// The cross angle psi = atan2(v, u) / 4 in [-pi/4, pi/4] of a field value (u, v) (paper, eq. 2).
inline double cross_angle(Vec2 value) { return angle_of(value) / 4; }

/// psi plus the multiple of pi/2 that brings it nearest to `direction`: the paper's adjusted angle psi'.
inline double guided_angle(Vec2 value, double direction) {
  const double psi = cross_angle(value);
  return psi + half_pi * std::round((direction - psi) / half_pi);
}

}  // namespace quadrille
