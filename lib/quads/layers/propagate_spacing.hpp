#pragma once
// Propagates fine intervals from the chords with layers into the chords that continue them (rules 19 to 22 of
// layer_rules), within the geometric tolerance of the boundary (rules 17, 18 and 23).

#include "layers/end_spacing.hpp"

namespace quadrille::layers {

/// Replaces the divisions of all arcs of the chord in `divisions` by layered_divisions. If a boundary arc misses the
/// tolerance, ends of intervals move onto its breaks, then its scale in `sizes` is reduced until it meets the
/// tolerance; at most LayerConstants::max_tolerance_rounds times. If the count is prescribed (WallInput::counts), it
/// rises in place of that, from the count that the arcs have without layers. `spacings`: by arc; `lines`: more lines
/// that the count must suit.
void divide_chord(const WallInput& input, int chord, const std::vector<ArcSpacing>& spacings,
                  const std::vector<FreePart>& lines, ArcSizes& sizes, sizing::ArcDivisions& divisions);

/// Prescribes the spacing `to` of an arc's end such that the arc continues from the first interval of a neighbour, if
/// its own is far coarser. `growth`: of the neighbour's chord. Returns whether the spacing changed.
bool continue_spacing(double neighbour_interval, double own_interval, double growth, EndSpacing& to);

/// Divides the chords with prescribed ends, then repeatedly those whose arcs begin far coarser than a neighbour ends.
/// Changes `spacings` (by arc), `sizes` and `divisions` accordingly. `chord_lines`: by chord, lines across its blocks
/// that its count must suit. Returns the numbers of the chords that were divided, ascending.
std::vector<int> propagate_spacing(const WallInput& input, const std::vector<std::vector<FreePart>>& chord_lines,
                                   std::vector<ArcSpacing>& spacings, ArcSizes& sizes, sizing::ArcDivisions& divisions);

}  // namespace quadrille::layers
