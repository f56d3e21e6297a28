#pragma once
// Quadrature rules on [-1, 1] (Karniadakis and Sherwin, app. B), for any number of points: Newton's method to
// round-off.

#include <vector>

namespace quadrille::spectral {

struct Quadrature {
  std::vector<double> points;   ///< ascending in [-1, 1]
  std::vector<double> weights;  ///< same length
};

/// n-point Gauss-Jacobi rule for the weight (1-x)^alpha (1+x)^beta: exact to degree 2n - 1.
Quadrature gauss_jacobi(int n, double alpha, double beta);
inline Quadrature gauss_legendre(int n) { return gauss_jacobi(n, 0, 0); }

/// n-point Gauss-Lobatto-Legendre rule (n >= 2), ends included: exact to degree 2n - 3.
Quadrature gauss_lobatto(int n);

/// The N + 1 Gauss-Lobatto-Legendre points of an edge of order N >= 1, ascending.
const std::vector<double>& gll_points(int order);

}  // namespace quadrille::spectral
