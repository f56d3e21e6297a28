#pragma once
// The tuned constants of healing, the lengths with which it compares, and how repairs are reported.

#include <string>

#include "base/angle.hpp"
#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/repair.hpp"

namespace quadrille::heal {

struct HealRules {
  // Parts of the diameter.
  double rounding = 1e-7;           ///< smaller gaps are rounding errors, closed when the loop is assembled
  double default_tolerance = 1e-5;  ///< unless the tolerances of the shape are larger
  double most_tolerance = 5e-3;     ///< the tolerances of the shape are believed up to here
  double large_tolerance = 1e-3;    ///< larger repairs are made with a warning

  // How far the end of a curve may move, besides the tolerance.
  double edge_fraction = 0.1;        ///< of its edge's length
  double sliding_fraction = 0.25;    ///< of a line's length, where the end stays on the line
  double clearance_fraction = 0.25;  ///< of the distance to other edges
  /// Tolerances: the most that lines which keep their directions slide to their intersection, if their gap is within
  /// the tolerance. Two lines at 15 degrees need 1 / sin 15 = 3.9.
  double sliding_reach = 4;

  // Which point two curves are moved to.
  double tangential = radians(1);   ///< curves that meet at a smaller angle have no well-posed intersection
  double kept_angle = radians(15);  ///< lines at a multiple of this angle are not turned
  double same_angle = 1e-6;         ///< radians: angles that differ by less are equal

  // How a curve yields.
  double least_chord = 0.5;  ///< of the curve's reach; a curve with a shorter chord is cut in its middle
  int most_cuts = 3;         ///< how often a curve is halved
  int most_passes = 4;       ///< a pass can make an edge shorter than the tolerance, which the next one removes
};

inline constexpr HealRules heal_rules;

/// How the tips of cusps are cut off.
struct BluntRules {
  double sharp_angle = blunted_angle;  ///< radians: corners below are cut off like cusps if a width is given
  double largest_cusp = 1e-6;          ///< radians: an interior angle up to here is zero
  double least_width = 1e-5;           ///< diameters: shorter edges are removed by healing
  double automatic_width = 1e-3;       ///< diameters: that of --blunt auto, or half of what the cusp allows
  double edge_fraction = 0.95;         ///< of an edge's length: the most that is cut off it
  int search_steps = 64;               ///< of the length that may be cut off, to find the first place as wide as asked
};

inline constexpr BluntRules blunt_rules;

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

/// Sets the entries heal.repair.<number>.
void report_repair(const Repair& repair, size_t number, Report& report);

}  // namespace quadrille::heal
