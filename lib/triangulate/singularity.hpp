#pragma once
// How singular the guiding field is at a junction of the boundary, and how many layers a fan there needs.
//
// After the exact lifting of the jump, a junction of interior angle omega leaves r^alpha terms (lib/method.md §3):
//   pi / omega = n an integer, straight sides   none: the field is smooth
//   pi / omega = n >= 2, a curved side          r^n log r
//   omega = pi, the curvature jumps             r log r;   its derivative jumps: r^2 log r
//   any other omega                             r^(pi / omega)

#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

struct Singularity {
  double exponent = 0;   ///< alpha; 0: the field is smooth here
  double amplitude = 0;  ///< of the term at the fan's radius, at most 1, |v| being 1 on the boundary
};

/// The leading term for a fan of radius `radius`.
Singularity junction_singularity(const Junction& junction, double radius);

/// ln(tol / amplitude^2) / (2 alpha ln factor), tol = 1e-10: the number of rings after which the rest of the term is
/// below tol in the far field. 0 where the term is so weak that order 8 alone resolves it.
int fan_layers(const Singularity& singularity, double factor);

}  // namespace quadrille::triangulate
