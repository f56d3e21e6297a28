#pragma once
// Error estimate of the field for each element, from the solution alone.
//
// Two parts (S_d: norm of the modes of degree d of both components, reference triangle):
//   own     tau_e = q max(S_P, S_{P-1}),  q^2 = max(S_P, S_{P-1}) / max(S_{P-2}, S_{P-3}):
//           the tail extrapolated by one degree at its own rate. Maxima over two degrees, because by symmetry every
//           other degree may vanish. On the boundary at least the misfit against the exact data on the exact curve.
//   remote  0.1 sum_f tau_f w_f,  w_f = R_f / d max((0.73 R_f / d)^(P_f + 1), tau_f / sigma_f) <= 1:
//           the solution minimises the energy, so element f contributes a(v - v_h, G_x - its best approximation) to the
//           error at x, with Green's function G_x: tau_f times the part of G_x that order P_f does not resolve. This is
//           the tail of a logarithm at distance d from an element of radius R_f (0.73 R: the capacity of a triangle),
//           or the unresolved part of the singularities of the domain, which G_x and v have in common: tau_f / sigma_f,
//           sigma_f the variation of v on f.
//
// Harmonic errors spread in this way from corners, fans and coarse elements without being visible in the modes of other
// elements. The value is an estimate, not a bound: tests/benchmarks/error_bars compares it with an independent
// reference solution.

#include <vector>

#include "base/progress.hpp"
#include "base/vec2.hpp"
#include "model/field.hpp"

namespace quadrille::field {

class PhaseBoundary;

/// The deviation of a field from its exact boundary data, including the shape error of curved edges: for each element,
/// the greatest |v_h(x_h) - v_b(t)| + |dv/dn| |x_h - x(t)| over sampled points of its boundary edges;
/// 0 for elements without boundary edge. x_h is the point of the element and x(t) the point of the curve at the same
/// arc length; only the component of x_h - x(t) normal to the curve counts. For a field of kind "phase", the same for
/// the phase, in radians: |s_h - g| + |dphi/dn| |x_h - x(t)|. `phase_boundary`: the data of the phase on this mesh, if
/// they were computed before.
std::vector<double> boundary_misfit(const Field& field, const PhaseBoundary* phase_boundary = nullptr);

/// Estimate of |v - v_h| on each element. For a field of kind "phase" it is |s - s_h|, which is the same to first order
/// because v is a unit vector. Cost: linear in the number of modes and of elements (only the 512 strongest sources are
/// summed). `phase_boundary`: see boundary_misfit().
std::vector<double> error_estimate(const Field& field, const PhaseBoundary* phase_boundary = nullptr,
                                   Progress* progress = nullptr);

/// Adds the squared norm of the modes of each degree to `norms`; `coefs`: in the orthogonal basis.
void add_squared_norms(const double* coefs, std::vector<double>& norms);

/// First-order bound of the displacement (a length) of a zero by a field error |e|: |J^-1 e| <= |e| / (least singular
/// value of J = dv/dx).
double position_error(const Mat2& jacobian, double field_error);

}  // namespace quadrille::field
