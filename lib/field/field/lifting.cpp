#include "field/lifting.hpp"

#include <cmath>

namespace quadrille::field {

double lifting_angle(const Lifting& lifting, Vec2 x) {
  const Vec2 a = x - lifting.apex, b = x - lifting.pole;
  return std::atan2(cross(b, a), dot(b, a));
}

Vec2 lifting_gradient(const Lifting& lifting, Vec2 x) {
  const Vec2 a = x - lifting.apex, b = x - lifting.pole;
  return left_of(a) / norm2(a) - left_of(b) / norm2(b);
}

double lifting_angle_at_apex(const Lifting& lifting, Vec2 d) {
  const Vec2 b = lifting.apex - lifting.pole;
  return std::atan2(cross(b, d), dot(b, d));
}

}  // namespace quadrille::field
