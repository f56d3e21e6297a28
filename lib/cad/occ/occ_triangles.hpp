#pragma once
// Edges and fine triangles of a curved OpenCASCADE face.

#include <vector>

#include "base/report.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_model.hpp"
#include "space/raw_space_face.hpp"

namespace quadrille::occ {

/// Sets surface, curves, triangles, polygons and inner edges of `raw`, whose labels have all but the wire, which is set
/// too. What the file leaves out is added on the way: parameter curves, seams, poles. Several faces become one
/// (occ_united_face.hpp). Warns of approximations. Throws FormatError if the kernel finds no triangles.
/// `heal_tolerance`: as in heal::HealOptions.
void read_curved_face(const OccModel& model, const std::vector<FaceChoice>& choices, double heal_tolerance,
                      space::RawSpaceFace& raw, Report& report);

}  // namespace quadrille::occ
