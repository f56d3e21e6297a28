#pragma once
// Valences of corners (lib/method.md §3): near a corner the field follows the chord between the data on its two sides,
// so that V is the integer nearest to 2 omega / pi. At omega = 45, 135, 225, 315 degrees the chord passes through 0: a
// tie, which the field away from the corner decides. This is the valence in the limit at the corner. Close to a tie a
// critical point may be too near to the corner for a block between: guide/find_critical_points decides about it. The
// blocks at a corner need angles between 15 and 165 degrees (§5), and all valences must have the index sum (§1).

#include <vector>

#include "base/angle.hpp"
#include "field/evaluate.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// What a corner of `valence` blocks adds to the angle defect: V (omega / (90 degrees V) - 1)^2. `angle`: omega,
/// radians.
inline double angle_defect(double angle, int valence) {
  const double off = angle / valence / half_pi - 1;
  return valence * off * off;
}

/// The distance between the ends of a boundary curve, a length.
inline double side_length(const CadFace& face, int curve) {
  return distance(face.joints[curve].position, face.joints[face.next_in_loop(curve)].position);
}

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

inline constexpr double least_block_angle = 15, greatest_block_angle = 165;  // degrees
inline constexpr int greatest_corner_valence = 4;

/// Whether a valence may be prescribed: it is 0 to 4, and angle / valence is between 15 and 165 degrees. Valence 0, a
/// degenerate corner, is admissible, and valence 1 also below 15 degrees: a sharp corner needs one block.
bool is_admissible_valence(double angle_degrees, int valence);

/// Whether a corner may have that valence because it absorbs nodes: angle / valence is between 15 and 165 degrees and
/// |valence - angle / 90 degrees| <= 0.75, so that blocks remain near right angles; valence 0 only within 0.02 radians
/// of the tie at 45 degrees.
bool is_admissible_after_absorption(double angle_degrees, int valence);

/// sum (4 - V) over the nodes, plus the indices of clusters, plus sum (2 - V) over corners and boundary nodes.
int index_sum_with_clusters(const CriticalPoints& points);

/// Throws ComputeError if index_sum != index_sum_expected, with the difference and the corner nearest to a tie.
void require_index_sum(const CriticalPoints& points, const CadFace& face);

}  // namespace quadrille::guide
