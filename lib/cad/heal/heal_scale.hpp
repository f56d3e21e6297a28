#pragma once
// The lengths with which healing compares, and what to do about those that are too large.

#include <string>

#include "heal/raw_face.hpp"

namespace quadrille::heal {

struct HealScale {
  std::string file;           ///< for messages
  double diameter = 1;        ///< of the face
  double tolerance = 0;       ///< the most that the end of a curve is moved
  double most_off_curve = 0;  ///< the most that a vertex lies off its curves
  double most_off_plane = 0;  ///< the most that an edge lies off the plane
  double short_fraction = 0;  ///< of the size of their wire: shorter edges are removed
  double rounding = 0;        ///< smaller gaps stay
};

/// The lengths for a face, or several faces, of this diameter, a length. `tolerance`: as in HealOptions.
HealScale heal_scale(const RawFace& raw, double tolerance, double diameter);

/// The last part of a message about a gap or distance of `size` beyond the tolerance: the tolerance that would do, or
/// that healing never moves anything as far.
std::string remedy(const HealScale& scale, double size);

}  // namespace quadrille::heal
