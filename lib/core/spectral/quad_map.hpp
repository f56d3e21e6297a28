#pragma once
// The element map of a quad of order N on [-1,1]^2, and proofs of its validity. Nodes at tensor Gauss-Lobatto-Legendre
// points, xi1 fastest (model/quad_mesh.hpp).

#include <vector>

#include "base/vec2.hpp"

namespace quadrille::spectral {

/// A proved lower bound of det J over [-1,1]^2, J with respect to (xi1, xi2). det J is a polynomial of degree 2N-1 in
/// each variable; the bound is its least Bernstein coefficient less a bound of the rounding errors, sharpened by up to
/// `depth` subdivisions while it is not positive (lib/method.md §7).
double quad_jacobian_lower_bound(int order, const Vec2* nodes, int depth = 4);

/// Least sampled scaled Jacobian det J / (|x_xi1| |x_xi2|) on (2N+3)^2 points, ends included; -1 where det J <= 0.
double quad_scaled_jacobian(int order, const Vec2* nodes);

/// The same, with the sample point (xi1, xi2) at which det J / (|x_xi1| |x_xi2|) is least.
struct ScaledJacobianMinimum {
  double value = 1;
  Vec2 xi;
};
ScaledJacobianMinimum quad_scaled_jacobian_minimum(int order, const Vec2* nodes);

/// Position at xi by interpolation.
Vec2 quad_position(int order, const Vec2* nodes, Vec2 xi);

}  // namespace quadrille::spectral
