#pragma once
// Edges of a face as the file gives them -> the checked boundary of model/cad_face.hpp. No kernel here.

#include "base/report.hpp"
#include "cad/raw_face.hpp"

namespace quadrille::cad {

/// Chains the edges of each wire, splits curves at tangent jumps, makes neighbours meet bit for bit, turns loops so
/// that the face lies on the left, sorts the outline first, and computes joints, names, diameter and origin.
/// Throws FormatError, saying what and where, for an open or self-intersecting wire, vertices off their edges, holes
/// outside or across the outline, or a face without area. `corner_angle` in radians.
CadFace assemble_face(const RawFace& raw, double corner_angle, Report& report);

}  // namespace quadrille::cad
