#pragma once
// Splines that approximate points in the sense of least squares, or a given curve.

#include <functional>
#include <optional>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// A point that the spline shall pass at `parameter`; `weight`: of the square of its distance.
struct FitPoint {
  double parameter = 0;
  Vec2 position;
  double weight = 1;
};

/// A knot of the spline, whose derivatives up to number degree - multiplicity are continuous there.
struct FitKnot {
  double parameter = 0;
  int multiplicity = 1;
};

/// What stays at the ends of an open spline: positions, and derivatives with respect to the parameter.
struct FitEnds {
  Vec2 start, start_derivative, end, end_derivative;
};

/// The spline with these knots, two or more, from the first to the last of them (multiplicities of both are ignored),
/// that has the least sum of weighted squares of distances from the points, which have ascending parameters. Cost:
/// linear in points and knots. Returns std::nullopt if the points do not determine the spline.
std::optional<Nurbs> least_squares_spline(int degree, const std::vector<FitKnot>& knots,
                                          const std::vector<FitPoint>& points, const FitEnds& ends);

/// The same for a closed curve: the last knot is the first one after a whole turn and has its multiplicity. Needs more
/// knots than the degree, counted with their multiplicities. The result is clamped and ends exactly where it begins.
std::optional<Nurbs> periodic_least_squares_spline(int degree, const std::vector<FitKnot>& knots,
                                                   const std::vector<FitPoint>& points);

/// As FitPoint and FitEnds.
struct SpaceFitPoint {
  double parameter = 0;
  Vec3 position;
};
struct SpaceFitEnds {
  Vec3 start_derivative, end_derivative;
};

/// The same in space, from the first point to the last one. Without `ends`: closed, as the periodic one.
std::optional<SpaceCurve> least_squares_spline(int degree, const std::vector<FitKnot>& knots,
                                               const std::vector<SpaceFitPoint>& points,
                                               const std::optional<SpaceFitEnds>& ends);

/// Position at s in [0, length]; sets the derivative with respect to s.
using CurveFunction = std::function<Vec2(double s, Vec2& derivative)>;

/// The spline through curve(s) at s = 0 .. length, parameter s, with the curve's own end derivatives. Intervals are
/// halved until at their quarter points the spline is within `tol` (a length) of the curve at the same parameter, or
/// until they are shorter than 1e-6 of the length (next to singular corners).
Nurbs fit_line(const CurveFunction& curve, double length, double tol);

}  // namespace quadrille::curve
