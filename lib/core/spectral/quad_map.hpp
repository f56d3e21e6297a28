#pragma once
// The element map of a quad of order N on [-1,1]^2, and proofs of its validity. Nodes at tensor Gauss-Lobatto-Legendre
// points, xi1 fastest (model/quad_mesh.hpp).
//
// det J is a polynomial in Bernstein form on the unit square, with a bound of its rounding errors. A polynomial of
// degree N through the N + 1 Gauss-Lobatto-Legendre nodes has the Bernstein coefficients b = M x. The entries of M are
// sums of products of one sign, as are the differences of neighbouring rows, which form the derivative. Both matrices
// are therefore known to a few units in the last place, although M as a whole is ill-conditioned (its norm grows like
// C(2N, N) / C(N, N/2)). For the latter reason the products with nodes are summed in extended precision.

#include <vector>

#include "base/vec2.hpp"
#include "base/vec3.hpp"

namespace quadrille::spectral {

/// A polynomial of degree (degree, degree): coefficient (i, j) at [j * (degree + 1) + i], i along xi1.
struct BernsteinSquare {
  int degree = 0;
  std::vector<double> coefs;
  double error = 0;  ///< bound of the difference of each coefficient from the exact one
};

/// det J with respect to (xi1, xi2) in [-1,1]^2, of degree 2N - 1 in each variable. `nodes` as in model/quad_mesh.hpp.
BernsteinSquare quad_jacobian_det(int order, const Vec2* nodes);

/// A lower bound of the polynomial on the square: its least coefficient less the error, sharpened by up to `depth`
/// bisections in both directions as long as it is not positive and no corner value proves that the polynomial is not
/// positive either.
double lower_bound(const BernsteinSquare& polynomial, int depth);

/// The least value on the square: not below the exact one, and above it by at most `tolerance` (> 0). Subdivides only
/// the parts whose coefficients allow a value below the least corner value found; quadratic in 1 / depth.
double least_value(const BernsteinSquare& polynomial, double tolerance);

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

// Elements in space. With the unit normal n0 at xi = 0, the normal component f = (X_xi1 x X_xi2) . n0 is det J of the
// element projected along n0: where f > 0 the projection is a valid planar element, so that the element is regular and
// nowhere folds over. The polynomial and its bounds are those of the plane (lib/method.md §12).

/// The nodes in a plane normal to n0, counter-clockwise seen against it.
std::vector<Vec2> quad_projection(int order, const Vec3* nodes);

/// A proved lower bound of the normal component, rounding of the projection included.
double quad_normal_lower_bound(int order, const Vec3* nodes, int depth = 4);

/// Least sampled sine of the angle between X_xi1 and X_xi2; -1 where the normal component is <= 0.
ScaledJacobianMinimum quad_scaled_jacobian_minimum(int order, const Vec3* nodes);

/// Position at xi by interpolation.
Vec2 quad_position(int order, const Vec2* nodes, Vec2 xi);
Vec3 quad_position(int order, const Vec3* nodes, Vec2 xi);

}  // namespace quadrille::spectral
