#pragma once
// A figure for the error of the field, element by element, from the solution alone.
//
// Two parts (S_d: norm of the modes of degree d of both components, reference triangle):
//   own     tau_e = q max(S_P, S_{P-1}),  q^2 = max(S_P, S_{P-1}) / max(S_{P-2}, S_{P-3}):
//           the tail carried on by one degree at its own rate. Maxima over two degrees, because symmetry empties every
//           other one. On the boundary no less than the misfit against the exact data of the exact curve.
//   from afar  0.1 sum_f tau_f w_f,  w_f = R_f / d max((0.73 R_f / d)^(P_f + 1), tau_f / sigma_f) <= 1:
//           the solution is best in energy, so element f sends its error to x by a(v - v_h, G_x - its best
//           approximation), G_x Green's function. That is tau_f times what order P_f cannot resolve of G_x: a logarithm
//           at distance d of an element of radius R_f (0.73 R: the capacity of a triangle), or what it cannot resolve
//           of the domain's own singularities, which G_x shares with v: tau_f / sigma_f, sigma_f the variation of v on
//           f.
// Harmonic errors spread like that from corners, fans and coarse elements without being seen in the modes of others.
// It is a figure, not a bound: tests/benchmarks/error_bars measures it against an independent truth.

#include <vector>

#include "base/vec2.hpp"
#include "model/field.hpp"

namespace quadrille::field {

/// |v - v_h| on each element; of a field of kind "phase" |s - s_h|, which is that as v is a unit vector. Linear in the
/// number of modes and of elements (the 512 strongest senders are heard).
std::vector<double> error_estimate(const Field& field);

/// How far a zero moves at most for an error of that size: |J^-1 e| <= |e| / (least singular value of J = dv/dx).
double position_error(const Mat2& jacobian, double field_error);

}  // namespace quadrille::field
