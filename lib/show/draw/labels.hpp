#pragma once
// The names of the regions of a face, written where each has most room, and numbers and names of the boundary curves,
// written beside them: what cad2tri --name and --boundary-names refer to.

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

/// Of each curve the first of the successive curves of its loop that have its given name; -1 without one, and of an
/// interface for the second of its two curves.
std::vector<int> name_runs(const CadFace& face);

/// Call it after all other texts. CurveLabels::given writes each given name beside the longest of successive curves
/// that have it; CurveLabels::all writes "4 hole" (without the name where it is made from the number) beside each
/// curve and draws a dot on each joint that is not a corner. Labels lie outside the face where there is room, else
/// inside or farther away with a line to the curve that the boundary does not cross; without a line no curve of another
/// label is nearer, so that labels of a thin hole lie on the sides that they name. They do not overlap each other,
/// other texts, the boundary or the lines. The curves of an interface have one label, "1/7 name" with both numbers, and
/// regions have their names in them. A label without room is reduced to its number, if it has one, then omitted; the
/// legend states how many are.
void label_curves(Picture& picture, const CadFace& face, CurveLabels which);

}  // namespace quadrille::draw
