#pragma once
// Midpoint division of degenerate corners (paper; lib/method.md §3), along the line through the middle of the wedge at
// the corner. The bisector of the tangents is not enough: where the sides of a sharp corner bend, it soon leaves the
// face.

#include <vector>

#include "base/enum_names.hpp"
#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Starts at the corner; positions are relative to face.origin.
struct MiddleLine {
  std::vector<Vec2> points;    ///< midpoints of the points of both sides at equal distances from the corner
  std::vector<double> widths;  ///< distances between these points of both sides
  double side = 0;             ///< arc length of the shorter side; half of a curve that is both sides
};

/// Of the corner at which curve `joint` starts. Straight sides have the bisector.
MiddleLine middle_line(const CadFace& face, int joint);

/// How long the line is inside the face; beyond its end it is continued straight.
double length_inside(const CadFace& face, const MiddleLine& line);

/// How far from the corner the line turns by less than `limit` times the angle under which the corner sees the wedge's
/// width there; infinite if it does everywhere.
double length_of_small_turn(const MiddleLine& line, double limit);

/// The point of the line at a length from the corner.
Vec2 point_at(const MiddleLine& line, double length);

/// Treatment of corners that are too sharp for a block: midpoint division, or none.
enum class DegeneratePolicy { divide, keep };
constexpr auto enum_names(DegeneratePolicy) { return std::to_array({"divide", "keep"}); }

/// Corners of valence 0 get valence 1 and a node of valence 3 in the middle of their wedge, at a distance of a quarter
/// of the wedge's length, at most half the shorter side, half the distance to any other node, and what a bent wedge
/// allows. Two of the node's lines meet the corner's sides at right angles, the third leads away
/// from the corner. Nodes and corners get the source `divide`; each corner is recorded as a change of that kind.
void divide_degenerate_corners(const CadFace& face, CriticalPoints& points);

/// Warns of corners below 15 degrees that have a block: no element there has a scaled Jacobian above the sine of the
/// angle.
void report_sharp_corners(const CadFace& face, const CriticalPoints& points, Report& report);

}  // namespace quadrille::guide
