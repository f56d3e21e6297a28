#pragma once
// Splines with many knots, such as those through measured or computed points, replaced by splines with few.

#include <optional>

#include "model/cad_face.hpp"

namespace quadrille::curve {

struct SimplifiedSpline {
  Nurbs curve;                            ///< degree 7, parameter: arc length of the old curve from its start
  double distance = 0;                    ///< greatest distance of points of both curves at the same arc length
  int knots_before = 0, knots_after = 0;  ///< different knots inside
};

/// A spline within `tolerance` (a length) of the curve, with at most half as many knots inside and as many breaks
/// (smoothness_breaks). Ends, tangents at the ends, and jumps of curvature that exceed the tolerance are kept; a knot
/// without such a jump has six continuous derivatives. A closed curve without a corner at its seam is fitted as a
/// periodic one: no derivative jumps at its seam, which may move by the tolerance.
///
/// Knots are bisected where the fit is too far off, by arc length, and lie at old ones: the reversed curve, and a
/// rotated or mirrored one, has the reversed, rotated or mirrored fit, up to rounding. The knots of a closed curve are
/// counted from its seam, so that a shape with several axes keeps its symmetry within the tolerance only.
///
/// Returns std::nullopt if the curve has fewer than 32 breaks, or if that many are needed. `tolerance`: above 0.
std::optional<SimplifiedSpline> simplified_spline(const Nurbs& curve, double tolerance);

}  // namespace quadrille::curve
