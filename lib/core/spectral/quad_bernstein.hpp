#pragma once
// det J of a quad element in Bernstein form on the unit square, with a bound of its rounding errors.
//
// A polynomial of degree N through the N + 1 Gauss-Lobatto-Legendre nodes has the Bernstein coefficients b = M x. The
// entries of M are sums of products of one sign, as are the differences of neighbouring rows, which form the
// derivative. Both matrices are therefore known to a few units in the last place, although M as a whole is
// ill-conditioned (its norm grows like C(2N, N) / C(N, N/2)). For the latter reason the products with nodes are summed
// in extended precision.

#include <vector>

#include "base/vec2.hpp"

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

}  // namespace quadrille::spectral
