#pragma once
// One count and one grading for each chord, from the prescribed sizes.

#include <array>
#include <vector>

#include "base/enum_names.hpp"
#include "sizing/grading.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// The rule for the single count of a chord whose arcs have different prescribed lengths.
enum class SizeRule {
  nearest,  ///< least deviation (sizing/chord_sections)
  at_most   ///< no edge is longer than prescribed
};
constexpr auto enum_names(SizeRule) { return std::to_array({"nearest", "at-most"}); }

/// A prescribed count.
struct ChordCount {
  int chord = 0, count = 1;
};

struct ChordPlan {
  Grading grading;
  int count = 1;
  double slope = 0;            ///< |d eta / du| of the grading is at most that (sizing/grading)
  bool is_bound = false;       ///< no edge may be longer (SizeRule::at_most)
  bool is_prescribed = false;  ///< the count is a prescribed one

  bool operator==(const ChordPlan&) const = default;
};

/// One plan per chord. Counts are rounded to the integer with the least deviation of the logarithm (at_most: upwards);
/// of two equally good ones (within 1e-6) the greater, so that mirror images agree. Throws UsageError for a prescribed
/// chord that does not exist.
std::vector<ChordPlan> grade_chords(const MeasuredLayout& measured, const SizeField& sizes, SizeRule rule,
                                    const std::vector<ChordCount>& prescribed);

/// The rounded count, at least 1, for a real number > 0.
double whole_count(double count, SizeRule rule);

}  // namespace quadrille::sizing
