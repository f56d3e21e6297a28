#pragma once
// Healing: makes the edges of a face from a CAD file lie in its plane and meet exactly.

#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/repair.hpp"

namespace quadrille::heal {

struct HealOptions {
  /// Diameters: the most that an edge or a vertex is moved. 0: no healing; negative: 1e-5, or the tolerances of the
  /// shape if they are larger, up to 5e-3.
  double tolerance = -1;
};

/// Projects edges to the plane, unfolds splines (unfold.hpp), merges their knots (merge_knots.hpp), puts the edges of
/// each wire in order, removes edges shorter than the tolerance (1e-5 of the size of the wire unless a tolerance is
/// given) and moves the ends of neighbours to one point (joint_target.hpp). Gaps below 1e-7 diameters stay as they are.
/// `diameter`: of the face, a length. Throws FormatError, with place, size and remedy, for what is beyond the tolerance
/// or beyond the limits of joint_limit.hpp. Healing a healed face changes nothing.
std::vector<Repair> heal_face(RawFace& raw, const HealOptions& options, double diameter, Report& report);

}  // namespace quadrille::heal
