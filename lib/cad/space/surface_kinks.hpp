#pragma once
// Kinks of a surface inside a face.

#include <optional>

#include "space/raw_space_face.hpp"

namespace quadrille::space {

struct SurfaceKink {
  bool is_u = true;      ///< along the line u = const
  double parameter = 0;  ///< of the line
  double angle = 0;      ///< between the normals on both sides, radians; the greatest in the face
  Vec3 position;         ///< where it is greatest
};

/// The first line on which the normal of the surface jumps inside the face by more than `angle`, radians. Lines on
/// which the face ends do not count; that on which the surface closes does, where the face goes across.
std::optional<SurfaceKink> kink_inside(const RawSpaceFace& raw, double angle);

}  // namespace quadrille::space
