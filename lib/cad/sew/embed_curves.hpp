#pragma once
// Curves inside a region, with the region on both sides.

#include <string>
#include <vector>

#include "sew/inner_curves.hpp"
#include "sew/region.hpp"

namespace quadrille::sew {

/// The region with those parts of `curves` that lie inside it as slits: each is there twice, in opposite directions
/// (Region::other_sides). Curves that cross each other or the boundary are split there, and so is the boundary where
/// one ends on it; ends are moved to joints, curves and ends within `tol` of them, a length. Curves that close around a
/// part of the region make two regions of it, of one name and number; no curve of these is a slit for that reason.
/// Throws FormatError, with place and remedy, beginning with `file`, for curves that run along each other or meet at an
/// angle of zero. Curves have no tangent jumps inside.
std::vector<Region> embed_curves(const Region& region, const std::vector<heal::LoopCurve>& curves, double tol,
                                 const std::string& file);

/// The loops of each region that the sides bound, the outline first, then holes and slits: numbers of sides.
std::vector<std::vector<std::vector<int>>> regions_of_sides(const std::vector<SideOfCurve>& sides);

/// Throws FormatError, with the edges and the place, if two curves of the region meet at an angle of zero, but at the
/// tips of slits. `other_sides`: as Region::other_sides.
void refuse_cusps(const Region& region, const std::string& file);

}  // namespace quadrille::sew
