#pragma once
// The clearance of a point: its distance to the boundary of the face, also along a ray, and the nearest boundary
// points. Positions are relative to face.origin, lengths in the file's unit.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::placement {

struct BoundaryFoot {
  int curve = 0;
  double t = 0;
  Vec2 position;
  double distance = 0;
};

/// The boundary points nearest to x: one of each curve whose distance is within 1e-6 diameters of the least distance.
std::vector<BoundaryFoot> nearest_feet(const CadFace& face, Vec2 x);

/// Distance to the boundary, negative outside the face.
double signed_clearance(const CadFace& face, Vec2 x);

/// Length of the first part of a ray that lies inside the face; 0 if the ray lies outside. `direction` is a unit
/// vector.
double clearance_along(const CadFace& face, Vec2 x, Vec2 direction);

}  // namespace quadrille::placement
