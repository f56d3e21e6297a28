#pragma once
// The ends of the intervals on the arcs of one chord that has layers at its ends, or that continues intervals finer
// than the prescribed size (rules 14 to 16 and 23 of layer_rules).
//
// All arcs have one count. An arc that starts at a wall has the layers at that end, then intervals that grow by at most
// the chord's growth up to the prescribed size (end_spacing). An arc beyond the end of the wall starts with the same
// first interval, but returns to its own division as fast as LayerConstants::greatest_slope allows over the distance
// from the wall's end: constant heights would result in needles throughout the domain, and an immediately free division
// would skew the elements beside the wall. The divisions of opposite arcs are then aligned (align_divisions).

#include <vector>

#include "layers/layered_chord.hpp"

namespace quadrille::layers {

/// One division for each arc of the chord, by position. `lines`: more lines that the count must suit.
/// `prescribed_count`: the count whatever arcs and lines need, if no arc has as many layers; 0: none.
std::vector<sizing::ArcDivision> layered_divisions(const LayeredChord& chord, const std::vector<FreePart>& lines,
                                                   int least_count, int prescribed_count = 0);

}  // namespace quadrille::layers
