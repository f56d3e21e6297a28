#pragma once
// Cusps of the boundary, and corners in which it touches itself: cut off at a given width, or refused.

#include <vector>

#include "base/report.hpp"
#include "heal/loop.hpp"
#include "model/repair.hpp"

namespace quadrille::heal {

struct BluntOptions {
  std::string file;     ///< for messages
  double diameter = 1;  ///< of the face, a length
  double width = 0;     ///< of the straight edges that replace tips, a length; 0: tips stay
};

/// Cuts off the tip of each cusp and sharp corner of the loops, which have the face on their left, and each convex
/// corner at a point of contact (touching_loops.hpp): both curves lose the same length, the least at which their new
/// ends are `width` apart, and a straight edge without name joins these ends. Adds a repair for each, also to the
/// report. Throws FormatError, with place and remedy, if the curves of a tip are too short or the width is below that
/// of short edges.
void blunt_cusps(std::vector<Loop>& loops, const BluntOptions& options, std::vector<Repair>& repairs, Report& report);

/// Throws FormatError, with place and a width that would do, if the loops touch themselves or each other.
void refuse_contacts(const std::vector<Loop>& loops, const BluntOptions& options);

/// Throws FormatError, with place and a width that would do, if there is a cusp.
void refuse_cusps(const std::vector<Loop>& loops, const BluntOptions& options);

}  // namespace quadrille::heal
