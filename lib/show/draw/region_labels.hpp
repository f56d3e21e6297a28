#pragma once
// The names of the regions of a face, written where each has most room.

#include <vector>

#include "draw/picture.hpp"

namespace quadrille::draw {

/// A point inside a region and its distance from the region's boundary, a length.
struct RegionPlace {
  Vec2 position;
  double clearance = 0;
};

/// Points of a lattice inside the region, those far from its boundary first, of these the one nearest to the centre of
/// its box. Cost: linear in the number of curves of the region.
std::vector<RegionPlace> region_places(const CadFace& face, int region);

/// Writes the name of each of several regions in it, omitted where it would cover the boundary or another text. Call it
/// after the texts that must keep their place.
void label_regions(Picture& picture, const CadFace& face);

}  // namespace quadrille::draw
