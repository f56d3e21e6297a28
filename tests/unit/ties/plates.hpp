#pragma once
// Plates with chamfers, for the tests of this folder.

#include <array>
#include <cmath>
#include <vector>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"

namespace quadrille::ties {

/// The outline of a plate w by h whose corners are cut off: the legs along x, from the lower left corner
/// counter-clockwise (0: not cut); the chamfers rise by `degrees`.
inline testing_faces::Loop plate_outline(double w, double h, const std::array<double, 4>& legs, double degrees = 45) {
  const double slope = std::tan(radians(degrees));
  std::vector<Vec2> points;
  const auto add = [&](Vec2 corner, double leg, double x, double y, bool along_x_first) {
    if (leg == 0) return points.push_back(corner);
    const Vec2 on_x = corner + Vec2{x * leg, 0}, on_y = corner + Vec2{0, y * slope * leg};
    points.push_back(along_x_first ? on_x : on_y);
    points.push_back(along_x_first ? on_y : on_x);
  };
  add({0, 0}, legs[0], 1, 1, false);
  add({w, 0}, legs[1], -1, 1, true);
  add({w, h}, legs[2], -1, -1, false);
  add({0, h}, legs[3], 1, -1, true);
  return testing_faces::polygon(points);
}

inline CadFace plate(double w, double h, const std::array<double, 4>& legs, double degrees = 45) {
  return testing_faces::make_face({plate_outline(w, h, legs, degrees)});
}

}  // namespace quadrille::ties
