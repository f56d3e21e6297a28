#pragma once
// Corners of embedded curves, at which lines of the two sides hardly meet.

#include <optional>

#include "model/cad_face.hpp"

namespace quadrille::couple {

struct InterfaceCorner {
  int joint = 0;
  double turn = 0;  ///< of the tangent there, radians, 0 to pi
};

/// The joint inside a face at which an embedded curve (a slit with both sides there) turns the most, if that is more
/// than 45 degrees: two blocks on each side then do not suit it. std::nullopt if there is none. Of equal ones the
/// first.
std::optional<InterfaceCorner> sharpest_interface_corner(const CadFace& face);

}  // namespace quadrille::couple
