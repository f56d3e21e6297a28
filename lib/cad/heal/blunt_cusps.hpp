#pragma once
// Cusps of the boundary, where the interior angle is zero, and corners in which it touches itself: cut off at a width,
// or refused.

#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "model/repair.hpp"

namespace quadrille::heal {

/// The angle between `in`, which ends where `out` starts, with the face on their left: 0 to 2 pi. If the tangents are
/// opposite, points of the curves near the joint decide between 0 and 2 pi.
double interior_angle(const Nurbs& in, const Nurbs& out);

/// Whether an interior angle is zero, up to rounding: the joint is a cusp, which holds no quad.
bool is_cusp(double interior_angle);

struct BluntOptions {
  std::string file;     ///< for messages
  double diameter = 1;  ///< of the face, a length
  double width = 0;     ///< of the straight edges that replace tips, a length; 0: tips stay; below 0: automatic_width
  bool keeps_contacts = false;  ///< corners that only touch another one stay: neighbours may lie between them
};

/// As BluntOptions::width: a thousandth of the diameter (in a far field, of the box around the bodies), or half of what
/// the edges of a tip allow if that is less.
inline constexpr double automatic_width = -1;

/// Cuts off the tip of each cusp and sharp corner of the loops, which have the face on their left, and each convex
/// corner at a point of contact (touching_loops.hpp): both curves lose the same length, the least at which their new
/// ends are `width` apart, and a straight edge without name joins these ends. Adds a repair for each, also to the
/// report, and a warning with their places, lengths and widths if the width is automatic. Throws FormatError, with
/// place and remedy, if the curves of a tip are too short or the width is below that of short edges.
void blunt_cusps(std::vector<Loop>& loops, const BluntOptions& options, std::vector<Repair>& repairs, Report& report);

/// Throws FormatError, with place and a width that would do, if the loops touch themselves or each other.
void refuse_contacts(const std::vector<Loop>& loops, const BluntOptions& options);

/// Throws FormatError, with place and a width that would do, if there is a cusp.
void refuse_cusps(const std::vector<Loop>& loops, const BluntOptions& options);

}  // namespace quadrille::heal
