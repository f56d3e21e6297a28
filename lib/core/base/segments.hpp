#pragma once
// Distances of straight segments.

#include <algorithm>

#include "base/vec2.hpp"

namespace quadrille {

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
