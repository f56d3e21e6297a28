#pragma once
// A piece of a curve parametrised by the fraction of its arc length: s(t) is the integral of a Chebyshev interpolant of
// the speed |dx/dt|. curve::ArcLength is the equivalent for a whole curve; this table is twenty times faster for many
// points of one element edge.

#include <array>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::triangulate {

/// Arc length and its inverse on one piece of a curve.
class ArcLengthTable {
 public:
  /// t0 < t1. The piece is divided at knots and where the interpolant is not accurate to round-off.
  ArcLengthTable(const Nurbs& curve, double t0, double t1);

  double length() const { return spans_.back().end; }
  /// The parameter at `fraction` in [0, 1] of the length.
  double parameter(double fraction) const;

 private:
  static constexpr int degree = 16;
  struct Span {
    double t0 = 0, t1 = 0;
    double begin = 0, end = 0;                ///< arc length from the beginning of the piece
    std::array<double, degree + 2> length{};  ///< Chebyshev coefficients of s on the span, 0 at t0
  };
  void add_span(const Nurbs& curve, double t0, double t1, double noise, int depth);

  std::vector<Span> spans_;
};

}  // namespace quadrille::triangulate
