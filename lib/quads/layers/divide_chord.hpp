#pragma once
// The division of a chord with prescribed ends, within the geometric tolerance of the boundary (rules 17, 18 and 23 of
// layer_rules).

#include <vector>

#include "layers/arc_sizes.hpp"
#include "layers/end_spacing.hpp"
#include "layers/wall_input.hpp"

namespace quadrille::layers {

/// Replaces the divisions of all arcs of the chord in `divisions` by layered_divisions. If a boundary arc misses the
/// tolerance, ends of intervals move onto its breaks, then its scale in `sizes` is reduced until it meets the
/// tolerance; at most LayerConstants::max_tolerance_rounds times. If the count is prescribed (WallInput::counts), it
/// rises in place of that, from the count that the arcs have without layers. `spacings`: by arc; `lines`: more lines
/// that the count must suit.
void divide_chord(const WallInput& input, int chord, const std::vector<ArcSpacing>& spacings,
                  const std::vector<FreePart>& lines, ArcSizes& sizes, sizing::ArcDivisions& divisions);

}  // namespace quadrille::layers
