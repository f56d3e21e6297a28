#pragma once
// Groups of equal chords, or of equal spiral shortcuts, are changed together or not at all, so that symmetric layouts
// stay symmetric.

#include <optional>
#include <vector>

#include "simplify/chord_collapse.hpp"
#include "simplify/spiral_shortcut.hpp"

namespace quadrille::simplify {

/// The blends that strips need together; std::nullopt if two have a common rail, or one of them cannot be collapsed.
std::optional<std::vector<Blend>> blends_of_group(const field::FieldsOfRegions& fields,
                                                  const graph::Subdivision& subdivision,
                                                  const std::vector<graph::ChordStrip>& strips,
                                                  const BlendOptions& options);

/// Collapses strips, given their blends. If one of them cannot be collapsed after others, the result is std::nullopt,
/// and the subdivision may have changed: make it a trial.
std::optional<ArcChanges> collapse_group(graph::Subdivision& subdivision, const std::vector<graph::ChordStrip>& strips,
                                         const std::vector<Blend>& blends);

/// The greatest deviation of blends, radians.
double greatest_deviation(const std::vector<Blend>& blends);

/// A compact subdivision, and the greatest deviation of its new lines (radians).
struct Shortened {
  graph::Subdivision subdivision;
  double deviation = 0;
};

/// A copy in which the shortcuts are taken. std::nullopt if one line has two shortcuts, if one of them does not fit, or
/// if the result is not a smaller number of four-sided blocks.
std::optional<Shortened> shorten_group(const field::FieldsOfRegions& fields, const graph::Subdivision& subdivision,
                                       const std::vector<SpiralShortcut>& shortcuts, const BlendOptions& options);

}  // namespace quadrille::simplify
