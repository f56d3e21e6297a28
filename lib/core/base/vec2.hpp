#pragma once
// Points and vectors of the plane, and 2 x 2 matrices, with the operations that the field analysis needs. Plain
// aggregates: cheap to compile, to copy and to store in arrays of the model.

#include <algorithm>
#include <cmath>

namespace quadrille {

struct Vec2 {
  double x = 0, y = 0;

  constexpr Vec2& operator+=(Vec2 b) { return x += b.x, y += b.y, *this; }
  constexpr Vec2& operator-=(Vec2 b) { return x -= b.x, y -= b.y, *this; }
  constexpr Vec2& operator*=(double s) { return x *= s, y *= s, *this; }
  constexpr bool operator==(const Vec2&) const = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr Vec2 operator*(Vec2 a, double s) { return {s * a.x, s * a.y}; }
constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// The z component of a x b: positive if b lies to the left of a.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// a rotated by a quarter turn counter-clockwise.
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
constexpr double norm2(Vec2 a) { return a.x * a.x + a.y * a.y; }
/// For lengths from 1e-150 to 1e150: a tenth of the cost of std::hypot, which has no such limits.
inline double norm(Vec2 a) { return std::sqrt(norm2(a)); }
inline Vec2 normalized(Vec2 a) { return a / norm(a); }
inline double distance(Vec2 a, Vec2 b) { return norm(b - a); }
/// The unit vector at `angle` (radians, counter-clockwise from the x axis).
inline Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
/// The angle of a in (-pi, pi].
inline double angle_of(Vec2 a) { return std::atan2(a.y, a.x); }

/// A 2 x 2 matrix by rows: [[xx, xy], [yx, yy]]. A Jacobian d f / d x has the derivatives of f_x in its first row.
struct Mat2 {
  double xx = 0, xy = 0, yx = 0, yy = 0;
};

constexpr Vec2 operator*(const Mat2& m, Vec2 a) { return {m.xx * a.x + m.xy * a.y, m.yx * a.x + m.yy * a.y}; }
constexpr Mat2 operator*(const Mat2& m, const Mat2& n) {
  return {m.xx * n.xx + m.xy * n.yx, m.xx * n.xy + m.xy * n.yy, m.yx * n.xx + m.yy * n.yx, m.yx * n.xy + m.yy * n.yy};
}
constexpr double det(const Mat2& m) { return m.xx * m.yy - m.xy * m.yx; }
/// The inverse; det(m) must not be 0.
constexpr Mat2 inverse(const Mat2& m) {
  const double d = det(m);
  return {m.yy / d, -m.xy / d, -m.yx / d, m.xx / d};
}

// Distances of straight segments.

/// Distance from x to the segment from a to b; a = b is allowed.
inline double distance_to_segment(Vec2 x, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length2 = norm2(d);
  const double f = length2 > 0 ? std::clamp(dot(x - a, d) / length2, 0.0, 1.0) : 0.0;
  return norm(x - (a + f * d));
}

/// True if the segments from a to b and from c to d cross at an interior point of both.
inline bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return c_side * d_side < 0 && a_side * b_side < 0;
}

/// Distance between the segments from a to b and from c to d, 0 if they cross.
inline double distance_of_segments(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (segments_cross(a, b, c, d)) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

}  // namespace quadrille
