#pragma once
// The line through the middle of the wedge at a corner. The bisector of the tangents is not enough: where the sides of
// a sharp corner bend, it soon leaves the face.

#include <vector>

#include "model/cad_face.hpp"

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

}  // namespace quadrille::guide
