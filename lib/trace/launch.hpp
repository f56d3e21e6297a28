#pragma once
// Where separatrices start, and in which directions (lib/method.md §6).
//
// A line leaves in direction alpha where the direction is one of the cross: 4 alpha = arg v (mod 2 pi). With v = J
// e(alpha) near a zero, and v on the straight chord between the data of both sides near a corner, G(alpha) = 4 alpha -
// arg v takes each value 2 pi k once for each k, but for fans: three solutions for one k, of which the middle one is
// launched and its neighbours run into it.
//
// A phase (lib/method.md §8.7) has exact directions: 4 alpha = phi_0 + d alpha beside a node of index d = 4 - V, so
// 360 / V degrees apart, and omega k / V at a corner or, with omega = pi, at a node on the boundary.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "field/evaluate.hpp"
#include "model/cad_face.hpp"

namespace quadrille::trace {

/// The V = 4 - sign(det J) directions at a simple zero with Jacobian `j` = d v / d x, radians, ascending from the axis
/// of J's greatest stretch.
std::vector<double> launch_directions(const Mat2& j);

/// The V directions at a zero of any index, from the field's values on a circle about it.
std::vector<double> launch_directions_on_circle(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                                int valence);

/// The V - 1 directions into the domain at a corner of valence V, as angles from the outgoing side's tangent,
/// ascending in (0, interior_angle).
std::vector<double> corner_launch_directions(double interior_angle, int valence);

/// The V directions at a node of a phase, radians, phi_0 as in field/node_phase.
std::vector<double> phase_launch_directions(double phi_0, int valence);

/// The V - 1 directions into the domain at a corner or boundary node of a phase: interior_angle k / V.
std::vector<double> phase_corner_launch_directions(double interior_angle, int valence);

/// A line from its node to where integration begins.
struct Launch {
  int node = 0;      ///< whose line it is, in the caller's count; -1 on the boundary
  Vec2 origin;       ///< the node's position
  double angle = 0;  ///< direction at the node
  double radius = 0;
  int elem = 0;  ///< element and reference coordinates of the first point
  Vec2 xi;
  Vec2 x;                  ///< its position
  double angle_there = 0;  ///< direction there
  int curve = -1;          ///< of a line that starts on the boundary: CAD curve and parameter
  double t = 0;
};

/// Goes `radius` along the direction `angle`, or less when that leaves the domain, on the curve whose direction
/// deviates from `angle` like distance^power: 1 at a zero of the field, pi / omega at a corner. Throws ComputeError
/// when no point of the domain lies in that direction.
Launch launch_line(const field::FieldEvaluator& evaluator, int node, Vec2 origin, double angle, double radius,
                   double power);

/// A line from a point of the boundary straight into the domain (cuts).
Launch launch_from_boundary(const field::FieldEvaluator& evaluator, int curve, double t);

}  // namespace quadrille::trace
