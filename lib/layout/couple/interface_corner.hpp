#pragma once
// Corners of embedded curves, at which lines of the two sides hardly meet.

#include <optional>

#include "model/cad_face.hpp"

namespace quadrille::couple {

struct InterfaceCorner {
  int joint = 0;
  double turn = 0;  ///< of the tangent there, radians, 0 to pi
};

/// The joint at which a curve with the face on both sides turns the most, the first of equal ones, if it turns by more
/// than 45 degrees: the nearest numbers of blocks on its two sides then differ. Else std::nullopt.
std::optional<InterfaceCorner> sharpest_interface_corner(const CadFace& face);

}  // namespace quadrille::couple
