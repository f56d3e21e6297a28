#pragma once
// A curve sampled by arc length, cut at its knots into cells. Private to this folder.

#include <array>
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

}  // namespace quadrille::curve
