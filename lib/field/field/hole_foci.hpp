#pragma once
// Centres of the turns D_j of a hole that is not round (lib/method.md §8.3).
//
// On an ellipse with foci f and f', 4 theta_t = 2 arg (z - f) + 2 arg (z - f') + const; on a parabola, 4 theta_t = 2
// arg (z - f) + const. Where the boundary of a hole turns by T in a sharp bend, 2 T / pi turns are therefore centred at
// the focus of the bend, at half its radius inside the hole. The remaining data are then resolved by a mesh that
// resolves the bend, however thin the hole. Any other points inside the hole are equally valid: only accuracy depends
// on the choice.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::field {

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
