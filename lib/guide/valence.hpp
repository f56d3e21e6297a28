#pragma once
// Valences of corners (method.md §3): near a corner the field follows the chord between the data on its two sides, so
// that V is the integer nearest 2 omega / pi. At omega = 45, 135, 225, 315 degrees the chord passes through 0: a tie,
// which the field away from the corner decides.

#include "field/evaluate.hpp"
#include "guide/zero_search.hpp"
#include "model/critical_points.hpp"

namespace quadrille {

/// How far the interior angle is from the nearest tie, radians in [0, pi/4].
double tie_distance(double interior_angle);

/// True when the angle is within 1e-6 radians of a tie.
inline bool is_tie(double interior_angle) { return tie_distance(interior_angle) < 1e-6; }

/// The disc about a tie's corner within which its zeros are taken as part of the corner: closer than any block could
/// be. At such a corner v vanishes like r^(pi/omega) along the bisector and no cell that touches it can be excluded.
Disc tie_disc(const CadFace& face, int joint);

/// All corners of the layout with their valences, in the sequence of the joints. At a tie V counts the quarter turns of
/// the cross along an arc about the corner, just outside its tie_disc. Throws ComputeError when that arc leaves the
/// domain or passes a zero.
std::vector<Corner> corner_valences(const FieldEvaluator& evaluator);

}  // namespace quadrille
