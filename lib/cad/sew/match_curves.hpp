#pragma once
// Which curves of different regions are the same curve, seen from both sides.

#include "sew/places.hpp"

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

}  // namespace quadrille::sew
