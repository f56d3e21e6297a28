#pragma once
// One count and one grading for each chord, from the wanted sizes.

#include <vector>

#include "sizing/grading.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// How far a chord's edges may be from the wanted lengths, which differ from arc to arc where the chord's count cannot.
enum class SizeRule {
  nearest,  ///< least deviation (sizing/chord_sections)
  at_most   ///< no edge is longer than wanted
};

/// A count that somebody asks for.
struct ChordCount {
  int chord = 0, count = 1;
};

struct ChordPlan {
  Grading grading;
  int count = 1;
  double slope = 0;            ///< |d eta / du| of the grading is at most that (sizing/grading)
  bool is_bound = false;       ///< no edge may be longer (SizeRule::at_most)
  bool is_prescribed = false;  ///< the count was asked for
};

/// One plan per chord. Counts go to the whole number whose deviation, by the logarithm, is least (at_most: upwards); of
/// two equally good ones (within 1e-6) the greater, so that mirror images agree. Throws UsageError for a prescribed
/// chord that is not there.
std::vector<ChordPlan> grade_chords(const MeasuredLayout& measured, const SizeField& sizes, SizeRule rule,
                                    const std::vector<ChordCount>& prescribed);

/// The whole number for a real one > 0, at least 1.
double whole_count(double wanted, SizeRule rule);

}  // namespace quadrille::sizing
