#pragma once
// A face with curves at distances from its walls, which blocks end at.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "offset/wall_chains.hpp"

namespace quadrille::offset {

/// The face with the offset curves of the walls embedded (sew/embed_curves.hpp): a curve around a hole, or along the
/// outline, makes two regions of the face, of one name. Curves keep their names, also those made from numbers, while
/// the numbers change; offset curves are called after their walls, "hole_offset". `corner_angle`: radians;
/// `symmetry`: patterns of the names of curves at lines of symmetry, where the curves are those of the whole. Reports
/// offsets.<number>.{names, distance, least}, by request; warning W-CAD-009 where the distance is less than prescribed.
/// Throws UsageError for names that do not exist or contradict each other, for distances below 1e-6 diameters, for
/// periodic sides and slits in a region with walls; ComputeError where a curve does not fit, with the place.
CadFace embed_offsets(const CadFace& face, const std::vector<OffsetRequest>& requests, double corner_angle,
                      const std::vector<std::string>& symmetry, Report& report);

}  // namespace quadrille::offset
