#pragma once
// Propagates fine intervals from the chords with layers into the chords that continue them (rules 19 to 22 of
// layer_rules).

#include <vector>

#include "layers/arc_sizes.hpp"
#include "layers/end_spacing.hpp"
#include "layers/wall_input.hpp"

namespace quadrille::layers {

/// Prescribes the spacing `to` of an arc's end such that the arc continues from the first interval of a neighbour, if
/// its own is far coarser. `growth`: of the neighbour's chord. Returns whether the spacing changed.
bool continue_spacing(double neighbour_interval, double own_interval, double growth, EndSpacing& to);

/// Divides the chords with prescribed ends, then repeatedly those whose arcs begin far coarser than a neighbour ends.
/// Changes `spacings` (by arc), `sizes` and `divisions` accordingly. `chord_lines`: by chord, lines across its blocks
/// that its count must suit. Returns the numbers of the chords that were divided, ascending.
std::vector<int> propagate_spacing(const WallInput& input, const std::vector<std::vector<FreePart>>& chord_lines,
                                   std::vector<ArcSpacing>& spacings, ArcSizes& sizes, sizing::ArcDivisions& divisions);

}  // namespace quadrille::layers
