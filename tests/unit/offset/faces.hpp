#pragma once
// Faces for tests of offset curves.

#include "../hand_made.hpp"

namespace quadrille::offset::testing_faces {

inline std::vector<Nurbs> polygon(const std::vector<Vec2>& corners) {
  std::vector<Nurbs> loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.push_back(curve::segment(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}

inline std::vector<Nurbs> rectangle(Vec2 low, Vec2 high) {
  return polygon({low, {high.x, low.y}, high, {low.x, high.y}});
}

/// 4 x 2, sides 0 to 3 from below.
inline CadFace plate() { return hand_made::face({rectangle({0, 0}, {4, 2})}, std::sqrt(20)); }

/// The same with a hole of radius 0.3 (curve 4) around (1, 1).
inline CadFace plate_with_hole() {
  return hand_made::face({rectangle({0, 0}, {4, 2}), {curve::circular_arc({1, 1}, 0.3, 2 * pi, 0)}}, std::sqrt(20));
}

/// An L: curves 2 and 3 meet in the corner (1, 1) at 270 degrees.
inline CadFace l_shape() {
  return hand_made::face({polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})}, std::sqrt(8));
}

}  // namespace quadrille::offset::testing_faces
