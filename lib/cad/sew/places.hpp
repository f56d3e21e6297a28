#pragma once
// The places at which curves of several regions end, and the cuts that they make in the curves of others.

#include <vector>

#include "sew/region.hpp"

namespace quadrille::sew {

/// A set of regions with the places at which their curves start.
struct Placed {
  std::vector<Region> regions;
  ByCurve<int> places;          ///< of the start of each curve; -1: the seam of a smooth closed curve is no place
  std::vector<Vec2> positions;  ///< of the places: where the region with the lowest number has it
  double greatest = 0;          ///< greatest distance from a place to the joint or curve of a region there, a length
};

/// Joints of different regions within `tol` of each other, a length, are one place; the nearest to each other are
/// united first, and no two joints of one region. A place within `tol` of the nearest curve of a region that has no
/// joint there splits this curve (a T-joint), except within 2 tol of its ends; slits are not split. A smooth closed
/// curve that is split has no seam afterwards. Curves keep their ends: move them to the places (curve_to_places). Cost:
/// quadratic in the number of joints.
Placed split_at_places(const std::vector<Region>& regions, double tol);

/// The curve of a region from place to place, bit for bit.
Nurbs curve_to_places(const Placed& placed, CurveId id);

}  // namespace quadrille::sew
