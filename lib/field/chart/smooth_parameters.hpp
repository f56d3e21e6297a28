#pragma once
// Smooth curves in space whose parameters are not: a circle of four rational arcs.

#include <vector>

#include "model/space_face.hpp"

namespace quadrille::chart {

/// Whether the curve is closed, and tangent and curvature are the same at both ends.
bool has_smooth_seam(const SpaceCurve& curve);

/// The face with such curves parametrised by arc length, as splines of degree 7 within 1e-13 of their length: a curve
/// in the chart with their parameters is as smooth as they are. Curves with smooth parameters, and those that bend at a
/// knot, remain as they are.
SpaceFace with_smooth_parameters(SpaceFace face);
SpaceCurve with_smooth_parameters(const SpaceCurve& curve);

}  // namespace quadrille::chart
