#pragma once
// How much room a face has about a point: nearest boundary points, lengths along rays, the most interior point.
// Positions are relative to face.origin, lengths in the file's unit.

#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"

namespace quadrille::placement {

struct BoundaryFoot {
  int curve = 0;
  double t = 0;
  Vec2 position;
  double distance = 0;
};

/// The boundary points nearest to x: one of each curve that comes within 1e-6 diameters of the least distance.
std::vector<BoundaryFoot> nearest_feet(const CadFace& face, Vec2 x);

/// Distance to the boundary, negative outside the face.
double signed_room(const CadFace& face, Vec2 x);

/// Length of the first stretch of a ray that lies inside the face; 0 where there is none. `direction` is a unit vector.
double room_along(const CadFace& face, Vec2 x, Vec2 direction);

/// The point with the largest smooth distance to the boundary (placement/wall_distance) among those that `group` leaves
/// where they are: on the mirror axis where there is one. Not for groups with rotations: they have one fixed point.
Vec2 most_interior_point(const CadFace& face, const std::vector<curve::Isometry>& group);

}  // namespace quadrille::placement
