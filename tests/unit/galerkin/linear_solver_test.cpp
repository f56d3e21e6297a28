#include "galerkin/linear_solver.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille {
namespace {

// The lower triangle of the n x n second difference matrix, times `scale`.
Eigen::SparseMatrix<double> second_difference(int n, double scale) {
  Eigen::SparseMatrix<double> matrix(n, n);
  for (int i = 0; i < n; ++i) {
    matrix.insert(i, i) = 2 * scale;
    if (i > 0) matrix.insert(i, i - 1) = -scale;
  }
  return matrix;
}

TEST(LinearSolver, SolvesBothRightHandSides) {
  // -x'' = 2 with zero ends has the solution s (n + 1 - s); a unit load at the first point a straight line.
  const int n = 9;
  Eigen::MatrixX2d rhs = Eigen::MatrixX2d::Zero(n, 2);
  rhs.col(0).setConstant(2);
  rhs(0, 1) = 1;
  const Eigen::MatrixX2d x = solve_symmetric(second_difference(n, 1), rhs);
  for (int i = 0; i < n; ++i) {
    EXPECT_NEAR(x(i, 0), (i + 1) * (n - i), 1e-12);
    EXPECT_NEAR(x(i, 1), (n - i) / (n + 1.0), 1e-14);
  }
}

TEST(LinearSolver, NothingToSolveIsFine) {
  EXPECT_EQ(solve_symmetric(Eigen::SparseMatrix<double>(0, 0), Eigen::MatrixX2d(0, 2)).rows(), 0);
}

TEST(LinearSolver, RefusesAnIndefiniteMatrix) {
  EXPECT_THROW(solve_symmetric(second_difference(4, -1), Eigen::MatrixX2d::Ones(4, 2)), ComputeError);
}

}  // namespace
}  // namespace quadrille
