#pragma once
// Directions in which separatrices start (lib/method.md §6).
//
// A direction alpha is one of the cross where 4 alpha = arg v (mod 2 pi). With v = J e(alpha) near a zero, and v on the
// straight chord between the values of both sides near a corner, G(alpha) = 4 alpha - arg v takes each value 2 pi k
// once for each k, except for fans: three solutions for one k. The middle one is launched; lines in the directions of
// its neighbours would run into it.
//
// A phase (lib/method.md §8.7) has exact directions: 4 alpha = phi_0 + d alpha beside a node of index d = 4 - V, so
// 360 / V degrees apart, and omega k / V at a corner or, with omega = pi, at a node on the boundary.

#include <vector>

#include "base/vec2.hpp"
#include "field/evaluate.hpp"

namespace quadrille::trace {

/// The V = 4 - sign(det J) directions at a simple zero with Jacobian `j` = d v / d x, radians, ascending from the axis
/// of J's greatest singular value.
std::vector<double> launch_directions(const Mat2& j);

/// The V directions at a zero of any index, radians, from the field's values on a circle about it.
std::vector<double> launch_directions_on_circle(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                                int valence);

/// The V - 1 directions into the domain at a corner of valence V, as angles from the outgoing side's tangent,
/// ascending in (0, interior_angle).
std::vector<double> corner_launch_directions(double interior_angle, int valence);

/// The V - 1 directions at a corner of valence V that absorbed zeros, from the field's values on an arc about it that
/// encloses these zeros: as corner_launch_directions, from the outgoing tangent's angle `tangent_out`. The launched
/// lines must start at the arc, since the field between it and the corner still has the zeros.
std::vector<double> launch_directions_on_arc(const field::FieldEvaluator& evaluator, Vec2 apex, double tangent_out,
                                             double interior_angle, double radius, int valence);

/// The V directions at a node of a phase, radians, phi_0 as in field/evaluate.
std::vector<double> phase_launch_directions(double phi_0, int valence);

/// The V - 1 directions into the domain at a corner or boundary node of a phase: interior_angle k / V.
std::vector<double> phase_corner_launch_directions(double interior_angle, int valence);

}  // namespace quadrille::trace
