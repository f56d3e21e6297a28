#pragma once
// Parts and kinks of a curve in space.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/chart.hpp"

namespace quadrille::space {

/// The curve whose x and y are those of `xy`, and whose z is the y of `xz`: two images of one curve, with the same
/// degree, knots and weights.
SpaceCurve combined(const Nurbs& xy, const Nurbs& xz);

/// The part of the curve from t0 to t1, with the same parameters (curve/nurbs.hpp).
SpaceCurve trimmed(const SpaceCurve& curve, double t0, double t1);

/// The curve from `start` to `end`, bit for bit, with the same knots: as in curve/nurbs.hpp.
SpaceCurve with_ends(SpaceCurve curve, Vec3 start, Vec3 end);

/// Inner knots at which the direction of the tangent jumps by more than 1e-9 radians.
std::vector<double> tangent_jumps(const SpaceCurve& curve);

/// Length of the control polygon.
double polygon_length(const SpaceCurve& curve);

}  // namespace quadrille::space
