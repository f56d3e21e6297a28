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
// disturbs it by (r0 / r)^(2 pi / omega): as many layers as for r^(pi / omega) of amplitude 1.

#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

struct Singularity {
  double exponent = 0;   ///< alpha; 0: the field is smooth
  double amplitude = 0;  ///< of the term at the fan's radius; at most 1, as |v| = 1 on the boundary
};

/// The leading term for a fan of radius `radius`.
Singularity junction_singularity(const Junction& junction, double radius);

/// ln(tol / amplitude^2) / (2 alpha ln factor), tol = 1e-10: the number of rings after which the rest of the term is
/// below tol in the far field. 0 if the term is so weak that order 8 resolves it without a fan.
int fan_layers(const Singularity& singularity, double factor);

}  // namespace quadrille::triangulate
