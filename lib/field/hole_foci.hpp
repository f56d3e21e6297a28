#pragma once
// Where a hole's turns D_j are centred if the hole is not round (lib/method.md §8.3).
//
// 4 theta_t of an ellipse is 2 arg (z - f) + 2 arg (z - f') but for a constant, f and f' its foci, and 2 arg (z - f) of
// a parabola: where a hole's boundary turns by T in a sharp bend, 2 T / pi turns belong to the bend's focus, half of
// its radius inside. Centred there, they leave data that a mesh made for the bend can follow, however thin the hole.
// Any other points inside would be as right: only accuracy depends on them.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::field {

struct HoleFocus {
  Vec2 position;  ///< inside the hole
  int loop = 1;   ///< of the hole
  int turns = 1;  ///< nearest whole number to 2 T / pi, positive
};

/// The foci of all bends of all holes that are sharper than the hole in the mean; none for a circle or a polygon.
/// Linear in the number of curves.
std::vector<HoleFocus> hole_foci(const CadFace& face);

}  // namespace quadrille::field
