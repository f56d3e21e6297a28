#pragma once
// Dirichlet data of the guiding field from the exact tangents of the CAD curves (paper, eq. 3).

#include <vector>

#include "model/cad_face.hpp"
#include "model/field.hpp"

namespace quadrille::field {

/// (cos 4 theta, sin 4 theta) of the curve's tangent at t; one-sided at the curve's ends.
Vec2 boundary_value(const CadFace& face, int curve, double t);

/// The sum of the liftings at parameter t of `curve`. At an end of the curve, the lifting of that joint is evaluated as
/// its limit along the curve.
Vec2 liftings_on_boundary(const CadFace& face, const std::vector<Lifting>& liftings, int curve, double t);

/// boundary_value minus all liftings, at parameter t of `curve`: continuous around every loop.
Vec2 lifted_boundary_value(const CadFace& face, const std::vector<Lifting>& liftings, int curve, double t);

/// Whether all boundary values lie on one line through 0, on both sides of 0: straight sides at odd and at even
/// multiples of 45 degrees. The field then vanishes along curves, and the harmonic method yields no layout
/// (lib/method.md §3).
bool is_line_field(const CadFace& face);

}  // namespace quadrille::field
