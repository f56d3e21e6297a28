#pragma once
// A rotation of the plane about a point.

#include <cmath>

#include "base/vec2.hpp"

namespace quadrille::curve {

struct Rotation {
  Vec2 centre;
  double angle = 0;  ///< radians

  Vec2 of_vector(Vec2 v) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
  }
  Vec2 of(Vec2 x) const { return centre + of_vector(x - centre); }
  Rotation inverse() const { return {centre, -angle}; }
};

}  // namespace quadrille::curve
