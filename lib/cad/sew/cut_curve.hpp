#pragma once
// A curve cut at places on it.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::sew {

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

}  // namespace quadrille::sew
