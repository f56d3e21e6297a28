#pragma once
// The hall of support/hall.hpp as a face with a triangle mesh, crosses along its walls, and corner valences.

#include <utility>
#include <vector>

#include "hall.hpp"
#include "square_field.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille {

inline Field field_of_hall(double step) {
  Report report;
  return interpolated_field(triangulate::triangulate(hall(step).graph().face, {}, report), 1, [](Vec2) {
    return Vec2{1, 0};
  });
}

/// Three at the reflex corners, one at the others.
inline CriticalPoints corners_of_hall(const CadFace& face) {
  CriticalPoints points;
  for (int j = 0; j < 8; ++j)
    points.corners.push_back(
        {j, face.joints[j].position, degrees(face.joints[j].interior_angle), j == 2 || j == 7 ? 3 : 1, {}});
  return points;
}

}  // namespace quadrille
