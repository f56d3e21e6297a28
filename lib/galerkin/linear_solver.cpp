#include "galerkin/linear_solver.hpp"

#include <Eigen/SparseCholesky>

#include "base/error.hpp"

namespace quadrille {

Eigen::MatrixX2d solve_symmetric(const Eigen::SparseMatrix<double>& matrix, const Eigen::MatrixX2d& rhs) {
  if (matrix.rows() == 0) return rhs;
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(matrix);
  if (factor.info() != Eigen::Success) throw ComputeError("the Laplace problem's matrix is not positive definite");
  return factor.solve(rhs);
}

}  // namespace quadrille
