#pragma once
// Dirichlet data of the guiding field from the exact tangents of the CAD curves (paper, eq. 3).

#include <vector>

#include "model/cad_face.hpp"
#include "model/field.hpp"

namespace quadrille::field {

/// (cos 4 theta, sin 4 theta) of the curve's tangent at t; one-sided at the curve's ends.
Vec2 boundary_value(const CadFace& face, int curve, double t);

/// boundary_value less all liftings, at the point of `curve` at t: continuous around every loop. At the curve's ends
/// the lifting of that joint takes its limit along the curve.
Vec2 lifted_boundary_value(const CadFace& face, const std::vector<Lifting>& liftings, int curve, double t);

/// Whether all data lie on one line through 0, both ways: sides straight at multiples of 45 degrees of both parities.
/// The field then vanishes on curves, and the harmonic method has no answer (lib/method.md §3).
bool is_line_field(const CadFace& face);

}  // namespace quadrille::field
