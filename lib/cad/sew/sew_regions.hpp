#pragma once
// Makes neighbouring faces of a plane share their curves: which are the same curve, and one curve for both.

#include <vector>

#include "sew/region.hpp"

namespace quadrille::sew {

struct Matched {
  ByCurve<CurveId> partners;  ///< the same curve of another region, in the opposite direction; a default CurveId: none
  double greatest = 0;        ///< greatest distance of two partners, a length
};

/// Curves between the same places in opposite directions that are within `tol` of each other, a length, everywhere;
/// each has at most one partner, the nearest are matched first. Smooth closed curves without places likewise.
Matched match_curves(const Placed& placed, double tol);

/// The greatest distance of a point of curve `a` from curve `b`, at samples of each knot span.
double one_sided_separation(const Nurbs& a, const Nurbs& b);

/// The greatest distance of a point of either curve from the other one, at samples of each knot span.
double separation(const Nurbs& a, const Nurbs& b);

struct Sewn {
  std::vector<Region> regions;
  /// The same curve of the neighbour, in the opposite direction: its poles and weights in the opposite order, bit for
  /// bit, and its knots mirrored. CurveId() on the boundary of the whole. Slits have their other side.
  ByCurve<CurveId> partners;
  ByCurve<int> places;       ///< number of the place at which each curve starts; -1: the seam of a smooth closed curve
  double greatest = 0;       ///< greatest distance by which a joint or a curve was moved, a length
  int num_interfaces = 0;    ///< pairs of partners in two regions
  int num_inner_curves = 0;  ///< pairs of partners in one region
};

/// Splits curves where a joint of a neighbour lies on them, finds the curves that two regions share, within `tol`, a
/// length, and replaces that of the region with the higher number by the other one's. Regions that do not meet stay as
/// they are; nothing is refused here (see one_sheet.hpp).
Sewn sew_regions(const std::vector<Region>& regions, double tol);

}  // namespace quadrille::sew
