#pragma once
// Merging of separatrices that meet head on (paper, "Integration of Streamlines").
//
// Line A from node P passes node Q, line B from Q passes P, running the other way. Both are taken up to the foot of the
// other's node and blended pointwise at equal shares f of their lengths,
//
//   M(f) = cos^2(pi f / 2) A(f) + sin^2(pi f / 2) B(1 - f),
//
// whose weights are flat at both ends: M leaves P along A and Q along B. The normal rule has no length in it: a pair is
// merged when that turns no part of the line by more than an angle. The aggressive rule merges as well what passes
// within a given distance at the place where fronts advancing at equal speed meet, or at both nodes. And it joins a
// line A that passes node Q within the distance, while no line of Q that comes its way passes P: A is led into Q
// against the launch direction e of that line, which is left out,
//
//   M(f) = A(f) + (3 f^2 - 2 f^3) (Q - A(1)) + (f^3 - f^2) (-|A| e - A'(1)).
//
// So is, whatever the distance, a line that ends in Q. Where two nodes have nearly cancelled, whole bundles of lines
// do, along one and the same direction.

#include <numbers>
#include <vector>

#include "curve/fit_line.hpp"
#include "trace/advance.hpp"

namespace quadrille::trace {

/// The most that merging may turn a line that would go on for ever, radians.
inline constexpr double greatest_merge_angle = 0.7;

/// The most that the aggressive rule may turn a line: beyond it lies the other family of lines.
inline constexpr double greatest_aggressive_angle = std::numbers::pi / 4;

struct MergeOptions {
  double max_angle = 0;       ///< radians
  double distance = 0;        ///< a length; 0: the normal rule only
  bool only_endless = false;  ///< only pairs of which one line has neither reached boundary nor node
};

/// Lines a and b, each used from its start up to the length given; a < b unless a is joined to b's node.
struct MergeCandidate {
  int a = 0, b = 0;
  double length_a = 0, length_b = 0;
  double turn = 0;       ///< largest angle between M and the blended directions, radians
  double gap = 0;        ///< the distance at which the aggressive rule takes it
  bool is_join = false;  ///< a is led into b's node, and b left out: length_b = length_a

  double length() const { return (length_a + length_b) / 2; }
  /// What fronts advancing at equal speed have gone together when they meet.
  double meeting() const { return is_join ? 2 * length_a : length(); }
};

/// All pairs that the rules allow, in the sequence in which fronts advancing at equal speed meet. Linear in lines times
/// nodes.
std::vector<MergeCandidate> merge_candidates(const field::FieldEvaluator& evaluator,
                                             const std::vector<Streamline>& lines, const std::vector<Vec2>& nodes,
                                             const MergeOptions& options);

/// Picks pairs in their sequence so that no line is in two; `taken` tells which lines are, before and after. Pairs
/// that meet after lengths that differ by less than 1e-6 of themselves are decided together: where two of them want one
/// line neither gets it, so that symmetric shapes stay symmetric. Only pairs with allowed[i] are looked at.
std::vector<int> choose_merges(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed,
                               std::vector<bool>& taken);

/// M as a function of f * length(), with its derivative.
curve::CurveFunction merged_curve(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                                  const MergeCandidate& candidate);

}  // namespace quadrille::trace
