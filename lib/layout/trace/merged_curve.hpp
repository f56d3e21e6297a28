#pragma once
// The curve that replaces two head-on separatrices (paper, "Integration of Streamlines").
//
// Line A from node P passes node Q, line B from Q passes P in the opposite direction. Both are cut at the foot of the
// other's node and blended pointwise at equal fractions f of their lengths,
//
//   M(f) = cos^2(pi f / 2) A(f) + sin^2(pi f / 2) B(1 - f),
//
// whose weights are flat at both ends: M starts along A and arrives along B. A join bends A, which passes or ends in Q,
// into Q against the launch direction e of a line B of Q, which is dropped,
//
//   M(f) = A(f) + (3 f^2 - 2 f^3) (Q - A(1)) + (f^3 - f^2) (-|A| e - A'(1)).

#include <cmath>

#include "curve/fit_line.hpp"
#include "trace/streamline.hpp"

namespace quadrille::trace {

/// Radians in [0, pi].
inline double angle_between(Vec2 a, Vec2 b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

/// Two lines, by their numbers, each used from its start up to the length given; a < b unless a is joined to b's node.
struct MergeCandidate {
  int a = 0, b = 0;
  double length_a = 0, length_b = 0;
  double deviation = 0;  ///< largest angle between M and the blended directions (a join: the field's cross), radians
  double gap = 0;        ///< the distance from which the aggressive rule allows it
  bool is_join = false;  ///< a is bent into b's node, and b is dropped: length_b = length_a

  double length() const { return (length_a + length_b) / 2; }
  /// Sum of the lengths covered by fronts that advance at equal speed when they meet.
  double meeting() const { return is_join ? 2 * length_a : length(); }
  /// Pairs are chosen in this order. A pair that bends waits for one that fits and is hardly longer: left unmerged, two
  /// lines that nearly coincide would bound a strip as thin as their distance.
  double delayed_meeting() const { return meeting() * (1 + deviation); }
};

/// M as a function of f * length(), with its derivative. The lines must outlive it.
curve::CurveFunction merged_curve(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                                  const MergeCandidate& candidate);

/// Computes the candidate's deviation. Returns false, with a lower bound of it, if it exceeds `max_deviation` (radians)
/// or if a joined line runs outside the domain.
bool deviates_at_most(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                      double max_deviation, MergeCandidate& candidate);

}  // namespace quadrille::trace
