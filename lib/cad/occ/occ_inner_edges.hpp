#pragma once
// Edges of no face that lie inside a curved face: cracks and other curves that blocks follow.

#include <string>

#include "base/report.hpp"
#include "occ/occ_united_face.hpp"

namespace quadrille::occ {

/// Adds to the inner edges those of no face that lie on the face within `tolerance`, a length, all of each, and not
/// along its boundary. The others are ignored with a warning: construction lines.
void add_edges_inside(const OccModel& model, const std::vector<FaceChoice>& choices, const std::string& file,
                      double tolerance, UnitedFace& united, Report& report);

}  // namespace quadrille::occ
