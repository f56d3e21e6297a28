#pragma once
// Valences of corners (lib/method.md §3): near a corner the field follows the chord between the data on its two sides,
// so that V is the integer nearest to 2 omega / pi. At omega = 45, 135, 225, 315 degrees the chord passes through 0: a
// tie, which the field away from the corner decides. This is the valence in the limit at the corner. Close to a tie a
// critical point may be too near to the corner for a block between: guide/absorb decides about it.

#include <vector>

#include "base/angle.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// Radians from a tie below which both neighbouring valences are equally good.
inline constexpr double near_tie = 0.02;

/// Radians from a tie below which the field is not asked for the valence: it is chosen by rule.
inline constexpr double tie_window = 2 * pi / 180;

/// Distance of the interior angle from the nearest tie, radians in [0, pi/4].
double tie_distance(double interior_angle);

struct CornerValences {
  std::vector<Corner> corners;     ///< in the order of the joints
  std::vector<zeros::Disc> discs;  ///< about the corners at ties: zeros inside are part of the valence
};

/// All corners of the layout, with the valence nearest to angle / 90 degrees.
CornerValences corner_valences_by_angle(const CadFace& face);

/// All corners of the layout. Within 1e-6 radians of a tie, V counts the quarter turns of the cross along an arc about
/// the corner (source "field"). It is the smallest arc on which |v| exceeds its errors: max(10 noise, 3 e), e the error
/// estimate there, and 20 times the distance from the tie, so that this distance does not decide. If no arc within a
/// fifth of the corner's curves satisfies this, the arc that is nearest to it. Throws ComputeError if |v| exceeds
/// 10 noise on no arc.
CornerValences corner_valences(const field::FieldEvaluator& evaluator, double noise = zeros::field_noise);

}  // namespace quadrille::guide
