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
  std::vector<int> arc2arc;      ///< the arc of each one before, -1 where it is gone
  std::vector<bool> is_changed;  ///< of the arcs: another shape than before
  double deviation = 0;          ///< greatest of the new lines, radians
};

/// Empty where two strips share a rail, or one of them cannot be collapsed.
std::optional<Trial> collapse_group(const field::FieldEvaluator& evaluator, const graph::Subdivision& subdivision,
                                    const std::vector<graph::ChordStrip>& strips, const BlendOptions& options);

/// Empty where one line has two shortcuts, or one of them does not fit or leaves other blocks than fewer four-sided
/// ones. Arcs are not followed.
std::optional<Trial> shorten_group(const field::FieldEvaluator& evaluator, const graph::Subdivision& subdivision,
                                   const std::vector<SpiralShortcut>& shortcuts, const BlendOptions& options);

}  // namespace quadrille::simplify
