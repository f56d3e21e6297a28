#pragma once
// Valences of corners (lib/method.md §3): near a corner the field follows the chord between the data on its two sides,
// so that V is the integer nearest 2 omega / pi. At omega = 45, 135, 225, 315 degrees the chord passes through 0: a
// tie, which the field away from the corner decides. This is the valence in the limit at the corner. Close to a tie a
// critical point may lie so near the corner that no block fits between: guide/absorb decides about it.

#include <vector>

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// Radians from a tie below which both neighbouring valences are as good.
inline constexpr double near_tie = 0.02;

/// How far the interior angle is from the nearest tie, radians in [0, pi/4].
double tie_distance(double interior_angle);

struct CornerValences {
  std::vector<Corner> corners;     ///< in the order of the joints
  std::vector<zeros::Disc> discs;  ///< about the corners at ties: what lies in them is part of the valence
};

/// All corners of the layout. Within 1e-6 radians of a tie V counts the quarter turns of the cross along an arc about
/// the corner (source "field"), the smallest on which |v| stands out of its errors: more than max(10 noise, 3 e), e the
/// error estimate there, and than 20 times the distance from the tie, so that it is not that which decides. Where no
/// arc within a fifth of the corner's curves does, the one that comes nearest to it. Throws ComputeError where none
/// exceeds 10 noise.
CornerValences corner_valences(const field::FieldEvaluator& evaluator, double noise = zeros::field_noise);

}  // namespace quadrille::guide
