#pragma once
// From the edges of a face in space to loops of curves that meet bit for bit: what heal and outline do in the plane.

#include "base/report.hpp"
#include "model/space_face.hpp"
#include "space/raw_space_face.hpp"

namespace quadrille::space {

/// `heal_tolerance`: the most that the end of a curve is moved, as in heal::HealOptions. Curves are cut where their
/// tangent jumps. Reports how far curves were moved (heal.*), and warns if curves lie off the surface. Throws
/// FormatError, with place, size and remedy, for wider gaps, and as boundary_loops does.
SpaceFace assemble_space_face(const RawSpaceFace& raw, double heal_tolerance, Report& report);

}  // namespace quadrille::space
