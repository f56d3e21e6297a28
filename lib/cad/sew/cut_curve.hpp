#pragma once
// Curves cut at places on them, joined, and crossed by others.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::sew {

/// The curve along `a` and then along `b`, which starts where `a` ends and has the same degree; exact, with an inner
/// knot of multiplicity `degree` between both. The parameters of `a` stay.
Nurbs joined_curve(const Nurbs& a, const Nurbs& b);

/// A place inside a curve.
struct Cut {
  double t = 0;
  int place = 0;
};

struct CutPiece {
  Nurbs curve;
  int start = 0;  ///< the place at which it starts
};

/// The pieces, in the order of the curve, which starts at place `start`. -1: it is closed and smooth at its seam, which
/// is no place; then the piece across the seam is joined, and without a cut the curve stays whole.
std::vector<CutPiece> cut_curve(const Nurbs& curve, std::vector<Cut> cuts, int start);

// Where two curves cross.

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
