#pragma once
// The centres of the turns D_j inside each hole (lib/method.md §8.3): a point h_j, and if the hole is not round the
// foci of its bends.
//
// On an ellipse with foci f and f', 4 theta_t = 2 arg (z - f) + 2 arg (z - f') + const; on a parabola, 4 theta_t = 2
// arg (z - f) + const. Where the boundary of a hole turns by T in a sharp bend, 2 T / pi turns are therefore centred at
// the focus of the bend, at half its radius inside the hole. The remaining data are then resolved by a mesh that
// resolves the bend, however thin the hole. Any other points inside the hole are equally valid: only accuracy depends
// on the choice.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::field {

/// The points h_j. For each hole (loops 1, 2, ...) its centroid. If the centroid lies outside the hole or much nearer
/// to the boundary than other points, the midpoint of the chord across the hole that has the greatest clearance. The
/// points move with the face and, if the centroid is used, do not depend on where the curves begin. For a loop of
/// slits, which encloses nothing, a point beyond the outline.
std::vector<Vec2> hole_points(const CadFace& face);

/// The focus of one bend of a hole.
struct HoleFocus {
  Vec2 position;  ///< inside the hole
  int loop = 1;   ///< of the hole
  int turns = 1;  ///< nearest whole number to 2 T / pi, positive
};

/// The foci of all bends of all holes whose curvature is well above the mean of their hole; empty for a circle or a
/// polygon. Cost: linear in the number of curves.
std::vector<HoleFocus> hole_foci(const CadFace& face);

}  // namespace quadrille::field
