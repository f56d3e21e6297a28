#pragma once
// Pairs of separatrices that may be merged, and the curve that replaces them (paper, "Integration of Streamlines").
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
//
// The normal rule is free of lengths: a head-on pair is merged if no part of the line changes its direction by more
// than a given angle. The aggressive rule also merges pairs that pass within a given distance, at the position where
// fronts that advance at equal speed meet, or at both nodes; and it joins a line A that passes a node Q within that
// distance, while no line of Q that runs towards A passes A's node, to Q. A line that ends in Q is joined to it at any
// distance. Where two nodes have nearly cancelled, whole bundles of lines do so along one and the same direction.

#include <vector>

#include "base/angle.hpp"
#include "curve/least_squares_spline.hpp"
#include "trace/streamline.hpp"

namespace quadrille::trace {

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

/// Limits of all merges, independent of the options; angles in radians.
struct MergeLimits {
  double endless_angle = 0.7;             ///< change of direction of a line that would never end
  double aggressive_angle = half_pi / 2;  ///< the same by the aggressive rule: beyond it the other family is nearer
  /// Between a line that passes a node and the line that starts there towards it. Lines turn by about 45 degrees as
  /// they pass a node: the deviation of the merged line decides.
  double head_on_angle = radians(75);
  double inequality = 0.3;  ///< of the two lengths, relative to their mean: fronts of a less equal pair never meet
};
inline constexpr MergeLimits merge_limits{};

struct MergeOptions {
  double max_angle = 0;       ///< radians
  double distance = 0;        ///< a length; 0: the normal rule only
  bool only_endless = false;  ///< only pairs of which one line has reached neither boundary nor node
};

/// All pairs that the rules allow, in the order in which fronts that advance at equal speed meet, delayed in proportion
/// to the deviation (MergeCandidate::delayed_meeting). Near linear in the number of lines times that of the nodes near
/// a line. `nodes`: positions, numbered as Launch::start.
std::vector<MergeCandidate> merge_candidates(const field::FieldEvaluator& evaluator,
                                             const std::vector<Streamline>& lines, const std::vector<Vec2>& nodes,
                                             const MergeOptions& options);

}  // namespace quadrille::trace
