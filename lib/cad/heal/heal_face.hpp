#pragma once
// Healing: makes the edges of a face from a CAD file lie in its plane and meet exactly. Also faults inside splines:
// stretches on which a curve runs back on itself, and knots that lie too close to each other.

#include <optional>
#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "model/repair.hpp"

namespace quadrille::heal {

/// Puts the poles at each fold in the order in which the curve passes them: a leg of the control polygon is a fold if
/// it is at most `most` long, a length, and runs against both of its neighbours. Returns how far the curve may have
/// moved, the greatest distance of a pole from its old position; 0 if there is no fold, or one that would move a pole
/// further than `most`: the curve is unchanged then. Unfolding an unfolded curve changes nothing.
double unfold(Nurbs& curve, double most);

struct MergedKnots {
  Vec2 position;
  double length = 0;  ///< of the curve between the first and the last of them
};

/// Merges breaks of the curve (curve::smoothness_breaks) with each other, or with an end of the curve, where the curve
/// between them is at most `most` long, a length: their knots become one knot, which loses poles if its multiplicity
/// exceeds the degree. The ends stay; other points move by less than the length. Returns the longest stretch between
/// merged breaks. Returns std::nullopt, and leaves the curve unchanged, if no breaks are so near to each other, or if
/// the whole curve is no longer than `most`.
std::optional<MergedKnots> merge_knots(Nurbs& curve, double most);

struct HealOptions {
  /// Diameters: the most that an edge or a vertex is moved. 0: no healing; negative: 1e-5, or the tolerances of the
  /// shape if they are larger, up to 5e-3.
  double tolerance = -1;
};

/// Projects edges to the plane, unfolds splines and merges their knots, puts the edges of each wire in order, removes
/// edges shorter than the tolerance (1e-5 of the size of the wire unless a tolerance is given) and moves the ends of
/// neighbours to one point (joint_target.hpp). Gaps below 1e-7 diameters stay as they are. `diameter`: of the face, a
/// length. Throws FormatError, with place, size and remedy, for what is beyond the tolerance or beyond the limits of
/// joint_target.hpp. Healing a healed face changes nothing.
std::vector<Repair> heal_face(RawFace& raw, const HealOptions& options, double diameter, Report& report);

}  // namespace quadrille::heal
