#pragma once
// Dense kernel of the sparse Cholesky factorisation: eliminates the first unknowns of a dense symmetric matrix.

#include <Eigen/Dense>

namespace quadrille::galerkin {

/// A symmetric matrix [A11 .; A21 A22], lower triangle.
struct Front {
  Eigen::MatrixXd panel;  ///< [A11; A21]: one column per eliminated unknown
  Eigen::MatrixXd rest;   ///< A22
};

/// panel := [L11; L21] with A11 = L11 L11^T and L21 = A21 L11^-T; rest := A22 - L21 L21^T (lower triangles). The upper
/// triangles are undefined. Returns false if A11 is not positive definite.
bool eliminate(Front& front, int num_threads);

}  // namespace quadrille::galerkin
