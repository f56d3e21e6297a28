#pragma once
// Pairs of separatrices that may be merged (paper, "Integration of Streamlines"; trace/merged_curve.hpp).
//
// The normal rule is free of lengths: a head-on pair is merged if no part of the line changes its direction by more
// than a given angle. The aggressive rule also merges pairs that pass within a given distance, at the position where
// fronts that advance at equal speed meet, or at both nodes; and it joins a line A that passes a node Q within that
// distance, while no line of Q that runs towards A passes A's node, to Q. A line that ends in Q is joined to it at any
// distance. Where two nodes have nearly cancelled, whole bundles of lines do so along one and the same direction.

#include <numbers>
#include <vector>

#include "trace/merged_curve.hpp"

namespace quadrille::trace {

/// Greatest change of direction by merging for a line that would never end, radians.
inline constexpr double max_endless_merge_angle = 0.7;

/// Greatest change of direction by the aggressive rule: beyond it the other family of lines is nearer.
inline constexpr double max_aggressive_angle = std::numbers::pi / 4;

struct MergeOptions {
  double max_angle = 0;       ///< radians
  double distance = 0;        ///< a length; 0: the normal rule only
  bool only_endless = false;  ///< only pairs of which one line has reached neither boundary nor node
};

/// All pairs that the rules allow, in the order in which fronts that advance at equal speed meet, delayed in proportion
/// to the deviation (MergeCandidate::delayed_meeting). Near linear in the number of
/// lines times that of the nodes near a line. `nodes`: positions, numbered as
/// Launch::node.
std::vector<MergeCandidate> merge_candidates(const field::FieldEvaluator& evaluator,
                                             const std::vector<Streamline>& lines, const std::vector<Vec2>& nodes,
                                             const MergeOptions& options);

}  // namespace quadrille::trace
