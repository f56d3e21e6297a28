#pragma once
// Limits the ratio of adjacent intervals along all lines of arcs: smooth divisions, with greater counts where these
// alone do not suffice.
//
// In each round the ends are moved (growth/smooth_divisions); where the limit is exceeded, again, with more and more
// weight on what exceeds it. Then chords get a tenth more free intervals, at least one, if one of
// their intervals misses the tolerance of the boundary, or is still too long beside a neighbour while none is too long
// beside it. Prescribed counts and layers stay. The rounds end when no ratio exceeds the limit, when the mesh would
// have `GrowthConstants::most_refined` times the elements, or after `patience` rounds without a better result.

#include <array>

#include "growth/smooth_divisions.hpp"

namespace quadrille::growth {

/// Divides all arcs of a chord into `count` intervals whose lengths follow those in `divisions`; layers and breaks of
/// the boundary remain ends of intervals. If equal parts of an arc compete for the last intervals, so that no choice
/// would be symmetric, the count is the next greater one with which none compete, of a few. Returns the count.
int recount_chord(const GrowthInput& input, int chord, int count, sizing::ArcDivisions& divisions);

struct GrowthConstants {
  int max_rounds = 60;
  int patience = 8;    ///< rounds without a better result before the last
  double raise = 0.1;  ///< part of its intervals between layers by which a chord is raised in each round
  /// Weights of ratios that exceed the limit, tried in this order until none does. Each minimisation starts from the
  /// result of the one before, so that it converges. Much greater weights skew blocks.
  std::array<double, 3> excess_weights{10, 30, 90};
  double most_refined = 4;     ///< elements, over those at first
  double warned_excess = 0.1;  ///< of the limit: lines inside blocks are smoothed, not limited
  double margin = 0.1;  ///< part of the limit's logarithm by which lines inside blocks aim at less than the limit: they
                        ///< are tied to their neighbours afterwards (layers/tied_lines)
  /// Part of the logarithm of the limit from which on excess is weighted: against the other terms, some remains.
  double excess_aim = 0.97;
  int max_tie_tries = 4;  ///< counts at which equal parts of an arc may compete for the last intervals
};
inline constexpr GrowthConstants growth_constants;

struct GrowthOutcome {
  double worst_before = 1;  ///< greatest ratio of adjacent intervals, longer over shorter, at first
  double worst = 1;         ///< and now
  int raised_chords = 0;    ///< chords whose count rose
  int num_kept = 0;         ///< chords whose count may not rise (smooth_arcs)
};

/// Changes `divisions` to those of the round with the least worst ratio; among equal ones to the first. None if every
/// round misses the tolerance of the boundary.
GrowthOutcome limit_growth(const GrowthInput& input, sizing::ArcDivisions& divisions);

}  // namespace quadrille::growth
