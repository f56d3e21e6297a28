#pragma once
// Where two curves cross.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::sew {

struct CurveCrossing {
  double t_a = 0, t_b = 0;  ///< parameters on both curves
  Vec2 position;            ///< on curve a
};

/// The points at which the curves cross, ascending by t_a, to round-off; points within `tol` of each other, a length,
/// count once. Throws FormatError, beginning with `what`, if they touch at an angle of zero or run along each other;
/// straight lines along each other have no crossings, nor has the point in which one curve ends and another one follows
/// it smoothly. Both curves are bisected until they are straight within `tol`.
std::vector<CurveCrossing> curve_crossings(const Nurbs& a, const Nurbs& b, double tol, const std::string& what);

}  // namespace quadrille::sew
