#pragma once
// Splines with many knots, such as those through measured or computed points, replaced by splines with few.

#include <array>
#include <optional>
#include <vector>

#include "curve/least_squares_spline.hpp"
#include "model/cad_face.hpp"

namespace quadrille::curve {

/// Where a cell ends: a knot of the curve or, on a long span, a point between knots.
struct FitNode {
  double parameter = 0;       ///< of the curve
  double length = 0;          ///< arc length from the start
  double curvature_jump = 0;  ///< absolute, 1 / length; at the ends of a closed curve from its end to its start
  double slope_jump = 0;      ///< of the curvature's derivative by arc length, 1 / length^2
};

struct FitCell {
  static constexpr int num_checks = 16;
  std::array<FitPoint, 8> points;           ///< at Gauss points, weights included; parameter: arc length
  std::array<FitPoint, num_checks> checks;  ///< at equal steps of the curve's parameter, from the start of the cell
};

struct FitCells {
  std::vector<FitNode> nodes;  ///< ascending
  std::vector<FitCell> cells;  ///< cell i is between nodes i and i + 1
};

/// No cell turns by more than about a quarter of a radian.
FitCells fit_cells(const Nurbs& curve);

/// The nodes, but for the first and the last, at which a jump stands out: no node that is nearer than H, a length, has
/// a jump half as large, and pieces as short as a quarter of H would still miss the tolerance if they had no jump of
/// the derivative of this order, 2 or 3, there.
std::vector<int> lasting_jumps(const std::vector<FitNode>& nodes, int order, double tolerance);

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
