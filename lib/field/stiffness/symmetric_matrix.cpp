#include "stiffness/symmetric_matrix.hpp"

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

}  // namespace quadrille::stiffness
