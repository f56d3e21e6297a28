#pragma once
// A cubic spline that approximates a given curve.

#include <functional>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// Position at s in [0, length]; sets the derivative with respect to s.
using CurveFunction = std::function<Vec2(double s, Vec2& derivative)>;

/// The spline through curve(s) at s = 0 .. length, parameter s, with the curve's own end derivatives. Intervals are
/// halved until at their quarter points the spline is within `tol` (a length) of the curve at the same parameter, or
/// until they are shorter than 1e-6 of the length (next to singular corners).
Nurbs fit_line(const CurveFunction& curve, double length, double tol);

}  // namespace quadrille::curve
