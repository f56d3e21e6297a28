#pragma once
// Positions of a face as messages and reports name them: in the plane of the CAD file, on curved faces in space.

#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "model/cad_face.hpp"

namespace quadrille::surface {

/// The point of the surface at x, a position of the chart relative to face.origin, by the polynomials of the chart; the
/// nearest node's outside of all triangles. The face must have a chart. Linear in the number of its triangles, without
/// set-up: for single places; mesh::ChartMap is for many.
Vec3 position_in_space(const CadFace& face, Vec2 x);

/// x, relative to face.origin, in the coordinates of the CAD file: two numbers in a plane, three on a curved face.
std::vector<double> position_in_file(const CadFace& face, Vec2 x);

/// The same as text, by the functions of these names of base/message_text.
std::string position_text(const CadFace& face, Vec2 x);
std::string rounded_position_text(const CadFace& face, Vec2 x);

}  // namespace quadrille::surface
