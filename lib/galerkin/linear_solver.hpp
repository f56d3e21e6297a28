#pragma once
// The sparse symmetric positive definite system of the edge and vertex unknowns, factored once for all right-hand
// sides.

#include <Eigen/Dense>
#include <Eigen/SparseCore>

namespace quadrille {

/// Solves matrix * x = rhs (columns). `matrix`: lower triangle, rows in a fill-reducing sequence already.
/// Throws ComputeError when the factorisation breaks down.
Eigen::MatrixX2d solve_symmetric(const Eigen::SparseMatrix<double>& matrix, const Eigen::MatrixX2d& rhs);

}  // namespace quadrille
