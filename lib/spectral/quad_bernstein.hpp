#pragma once
// det J of a quad element as a Bernstein form on the unit square, with a bound of its rounding errors.
//
// A polynomial of degree N through the N + 1 Gauss-Lobatto-Legendre nodes has the Bernstein coefficients b = M x. The
// entries of M are sums of products of one sign, as are the differences of neighbouring rows that give the derivative,
// so both matrices are known to a few units in the last place, although M as a whole is ill-conditioned (its norm grows
// like C(2N, N) / C(N, N/2)). The products with nodes are summed in extended precision for that reason.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille::spectral {

/// A polynomial of degree (degree, degree): coefficient (i, j) at [j * (degree + 1) + i], i along xi1.
struct BernsteinSquare {
  int degree = 0;
  std::vector<double> coefs;
  double error = 0;  ///< no coefficient differs from the exact one by more
};

/// det J with respect to (xi1, xi2) in [-1,1]^2, of degree 2N - 1 in each variable. `nodes` as in model/quad_mesh.hpp.
BernsteinSquare quad_jacobian_det(int order, const Vec2* nodes);

/// A lower bound of the polynomial on the square: its least coefficient less the error, sharpened by up to `depth`
/// bisections in both directions while it is not positive and no corner value proves that it cannot be.
double lower_bound(const BernsteinSquare& polynomial, int depth);

/// The least value on the square: not below the exact one, and above it by `tolerance` (> 0) at most. Only parts are
/// halved whose coefficients leave room for less than what a corner has attained; quadratic in 1 / depth.
double least_value(const BernsteinSquare& polynomial, double tolerance);

}  // namespace quadrille::spectral
