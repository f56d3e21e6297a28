#pragma once
// Circular regions, discs and rings, may be rotated: their field prefers no direction.

#include <vector>

#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// Angles about the centre at which lines end on a loop: of the region, and of its neighbours. Radians.
struct EndAngles {
  std::vector<double> own, others;
};

/// The angle with the least sum of squares from each own end to the nearest other one. Where several are equally good,
/// as where the neighbours' lines are symmetric, the best one in the middle between two of them, which is symmetric as
/// well; if there are several of those too, the least in magnitude of the equally good ones. Angles that bring the own
/// ends to the same places are one.
double best_rotation(const std::vector<EndAngles>& loops);

/// Rotates the layout of each region bounded by circles about one centre so that its lines end as near as possible to
/// those of its neighbours: first of regions beside one that is not circular, then of those beside them. Sets
/// regions.rotations. Returns the number of regions that were rotated.
int rotate_circular_regions(RegionLayouts& regions);

}  // namespace quadrille::couple
