#pragma once
// Circular regions, discs and rings, may be rotated: their field prefers no direction.

#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// Rotates the layout of each region bounded by circles about one centre so that its lines end as near as possible to
/// those of its neighbours: first of regions beside one that is not circular, then of those beside them. Sets
/// regions.rotations. Returns the number of regions that were rotated.
int rotate_circular_regions(RegionLayouts& regions);

}  // namespace quadrille::couple
