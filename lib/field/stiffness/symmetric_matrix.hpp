#pragma once
// A symmetric matrix in half of the memory: elements keep most of what a solution needs.

#include <Eigen/Dense>

namespace quadrille::stiffness {

/// The lower triangle, column by column.
class SymmetricMatrix {
 public:
  SymmetricMatrix() = default;
  /// From the lower triangle of a square matrix; its upper triangle is not read.
  explicit SymmetricMatrix(const Eigen::MatrixXd& lower);

  Eigen::Index rows() const { return rows_; }
  /// All entries.
  Eigen::MatrixXd dense() const;

 private:
  Eigen::Index rows_ = 0;
  Eigen::VectorXd columns_;
};

}  // namespace quadrille::stiffness
