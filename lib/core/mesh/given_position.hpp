#pragma once
// The place on a face of a position that a user gives.

#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"

namespace quadrille::mesh {

/// Of a planar face as curve::face_position; of a curved one the point of the chart, relative to face.origin, of the
/// nearest point of the face, which must be at most a thousandth of the diameter away. Throws FormatError, with a
/// message that begins with `where`, if it is not, and for two coordinates.
Vec2 given_position(const CadFace& face, const std::vector<double>& coordinates, const std::string& where);

}  // namespace quadrille::mesh
