#pragma once
// One point h_j inside each hole, the centre of arg(z - h_j) (lib/method.md §8.3).

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::field {

/// For each hole (loops 1, 2, ...) its centroid. If the centroid lies outside the hole or much nearer to the boundary
/// than other points, the midpoint of the chord across the hole that has the greatest clearance. The points move with
/// the face and, if the centroid is used, do not depend on where the curves begin. For a loop of slits, which encloses
/// nothing, a point beyond the outline.
std::vector<Vec2> hole_points(const CadFace& face);

}  // namespace quadrille::field
