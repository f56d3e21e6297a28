#include "stiffness/condense.hpp"

#include <utility>

#include "base/error.hpp"

namespace quadrille::stiffness {

SymmetricMatrix::SymmetricMatrix(const Eigen::MatrixXd& lower)
    : rows_(lower.rows()), columns_(lower.rows() * (lower.rows() + 1) / 2) {
  for (Eigen::Index j = 0, first = 0; j < rows_; first += rows_ - j, ++j)
    columns_.segment(first, rows_ - j) = lower.col(j).tail(rows_ - j);
}

Eigen::MatrixXd SymmetricMatrix::dense() const {
  Eigen::MatrixXd all(rows_, rows_);
  for (Eigen::Index j = 0, first = 0; j < rows_; first += rows_ - j, ++j) {
    all.col(j).tail(rows_ - j) = columns_.segment(first, rows_ - j);
    all.row(j).tail(rows_ - j) = columns_.segment(first, rows_ - j).transpose();
  }
  return all;
}

CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure) {
  const Eigen::LLT<Eigen::MatrixXd> factored(k_ii);  // L L^T
  if (factored.info() != Eigen::Success) throw ComputeError(failure);
  Eigen::MatrixXd interior = -k_ib, schur = k_bb;
  factored.matrixL().solveInPlace(interior);
  schur.selfadjointView<Eigen::Lower>().rankUpdate(interior.transpose(), -1);
  factored.matrixU().solveInPlace(interior);
  return {SymmetricMatrix(schur), std::move(interior), {}};
}

CondensedElement condense(int order, const Eigen::MatrixXd& stiffness) {
  const int nb = spectral::num_boundary_modes(order), ni = spectral::num_interior_modes(order);
  return eliminate_interior(stiffness.bottomRightCorner(ni, ni), stiffness.bottomLeftCorner(ni, nb),
                            stiffness.topLeftCorner(nb, nb), "an element's stiffness matrix is not positive definite");
}

}  // namespace quadrille::stiffness
