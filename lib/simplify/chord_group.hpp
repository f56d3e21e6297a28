#pragma once
// Trials on copies of a subdivision: groups of equal chords, or of equal spiral shortcuts, are changed together or not
// at all, so that symmetric layouts stay symmetric.

#include <optional>
#include <vector>

#include "simplify/chord_collapse.hpp"
#include "simplify/spiral_shortcut.hpp"

namespace quadrille::simplify {

struct Trial {
  graph::Subdivision subdivision;
  std::vector<int> arc2arc;      ///< the new arc of each old one, -1 if it was removed
  std::vector<bool> is_changed;  ///< by new arc: its shape has changed
  double deviation = 0;          ///< greatest of the new lines, radians
};

/// std::nullopt if two strips have a common rail, or one of them cannot be collapsed.
std::optional<Trial> collapse_group(const field::FieldEvaluator& evaluator, const graph::Subdivision& subdivision,
                                    const std::vector<graph::ChordStrip>& strips, const BlendOptions& options);

/// std::nullopt if one line has two shortcuts, if one of them does not fit, or if the result is not a smaller number of
/// four-sided blocks. `arc2arc` is not filled in.
std::optional<Trial> shorten_group(const field::FieldEvaluator& evaluator, const graph::Subdivision& subdivision,
                                   const std::vector<SpiralShortcut>& shortcuts, const BlendOptions& options);

}  // namespace quadrille::simplify
