#pragma once
// The isometries of the plane that map a face onto itself.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille {

/// x -> centre + R(angle) [mirror] (x - centre), mirror: the reflection (x, y) -> (x, -y), applied first.
struct Isometry {
  Vec2 centre;
  double angle = 0;  ///< radians
  bool is_mirrored = false;

  Vec2 operator()(Vec2 x) const;
};

/// The largest finite group that can be told: identity first, then rotations by ascending angle, then mirrored ones.
/// Faces bounded by concentric circles have infinitely many; the dihedral group of order 8 about a fixed direction is
/// given for them. An isometry counts when it maps every curve onto the boundary within 1e-7 diameters.
std::vector<Isometry> symmetries(const CadFace& face);

}  // namespace quadrille
