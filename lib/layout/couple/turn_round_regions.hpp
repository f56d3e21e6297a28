#pragma once
// Regions whose boundary is round, a disc or a ring, may be turned: their field prefers no direction.

#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// Turns the layout of each region bounded by circles about one centre so that its lines end as near as possible to
/// those of its neighbours: first of regions beside one that is not round, then of those beside them. Sets
/// regions.turns. Returns the number of regions that were turned.
int turn_round_regions(RegionLayouts& regions);

}  // namespace quadrille::couple
