#pragma once
// Converts a position given by a user to a position in the face's plane.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// `coordinates`: x, y of the plane, with face.origin, or x, y, z of the CAD model's space. The result is relative to
/// face.origin, as all positions are. Throws FormatError, with a message that begins with `where`, if a position in
/// space lies more than a thousandth of the diameter off the plane.
Vec2 face_position(const CadFace& face, const std::vector<double>& coordinates, const std::string& where);

}  // namespace quadrille::curve
