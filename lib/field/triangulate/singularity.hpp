#pragma once
// Leading singular term of the guiding field at a junction of the boundary, and the number of layers of a fan that
// resolves it.
//
// After subtraction of the exact lifting of the jump, the field at a junction of interior angle omega contains r^alpha
// terms (lib/method.md §3):
//   pi / omega = n an integer, straight sides   none: the field is smooth
//   pi / omega = n >= 2, a curved side          r^n log r
//   omega = pi, the curvature jumps             r log r;   its derivative jumps: r^2 log r
//   any other omega                             r^(pi / omega)
//
// Where the jump is bridged (at slits), the field depends on the angle alone down to the length r0 of the bridge, which
// disturbs it by (r0 / r)^(2 pi / omega), whatever the order: as many layers as for r^(pi / omega) of amplitude 1 with
// apex elements that resolve nothing of it.

#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

struct Singularity {
  double exponent = 0;   ///< alpha; 0: the field is smooth
  double amplitude = 0;  ///< of the term at the fan's radius; at most 1, as |v| = 1 on the boundary
  int apex_order = 8;  ///< of the elements at the apex, which leave 1 / apex_order^(2 alpha) of the term; 1: all of it
};

/// The leading term for a fan of radius `radius`.
Singularity junction_singularity(const Junction& junction, double radius);

/// ln(tol / a^2) / (2 alpha ln factor), tol = 1e-10, a = amplitude / apex_order^(2 alpha): the number of rings after
/// which what the apex elements leave of the term is below tol in the far field. 0 if it is so without a fan.
int fan_layers(const Singularity& singularity, double factor);

/// The greatest length of the element edges at a junction without a fan where only the derivative of the curvature
/// jumps, as at every knot of a C2 spline: on longer elements the term r^2 log r is above what order 20 resolves.
/// Infinite if nothing jumps.
double greatest_edge_length(const Junction& junction);

}  // namespace quadrille::triangulate
