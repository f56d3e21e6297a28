#pragma once
// Valences of corners (method.md §3): near a corner the field follows the chord between the data on its two sides, so
// that V is the integer nearest 2 omega / pi. At omega = 45, 135, 225, 315 degrees the chord passes through 0: a tie,
// which the field away from the corner decides. Close to a tie a critical point may lie so near the corner that no
// block fits between: the corner absorbs it, its valence V becomes V + V_k - 4.

#include <vector>

#include "field/evaluate.hpp"
#include "guide/zero_search.hpp"
#include "model/critical_points.hpp"

namespace quadrille {

/// How far the interior angle is from the nearest tie, radians in [0, pi/4].
double tie_distance(double interior_angle);

struct CornerValences {
  std::vector<Corner> corners;  ///< in the sequence of the joints
  std::vector<Disc> discs;      ///< about the corners close to ties: what lies in them is part of the valence
};

/// All corners of the layout. Within 0.02 radians of a tie V counts the quarter turns of the cross along an arc about
/// the corner, at 2e-3 of the diameter where there is room. Throws ComputeError when that arc leaves the domain or
/// passes a zero and the corner is within 1e-6 radians of the tie.
CornerValences corner_valences(const FieldEvaluator& evaluator);

}  // namespace quadrille
