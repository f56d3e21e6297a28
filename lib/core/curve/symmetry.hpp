#pragma once
// The isometries of the plane that map a face onto itself.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// x -> centre + R(angle) [mirror] (x - centre), mirror: the reflection (x, y) -> (x, -y), applied first. A mirrored
/// isometry is the reflection at the line through the centre in the direction angle / 2.
struct Isometry {
  Vec2 centre;
  double angle = 0;  ///< radians
  bool is_mirrored = false;

  Vec2 operator()(Vec2 x) const;
  /// The image of a direction: the same map without the centre.
  Vec2 turned(Vec2 direction) const;
};

/// The largest finite group that can be detected: identity first, then rotations by ascending angle, then mirrored
/// isometries by ascending angle. Their common centre is the face's centroid. A face bounded by concentric circles has
/// infinitely many; for it the dihedral group of order 8 with one axis through joint 0 is returned. An isometry is
/// accepted if it maps every curve onto the boundary within `tolerance` diameters. This is tested for the smallest
/// rotation and for one mirrored isometry; the others are their products, exact to round-off. Cost: a projection of a
/// few points of each knot span for each candidate that the crossings of one circle about the centre do not rule out.
std::vector<Isometry> symmetries(const CadFace& face, double tolerance = 1e-7);

}  // namespace quadrille::curve
