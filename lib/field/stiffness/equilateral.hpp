#pragma once
// The equilateral triangle, which stands for elements of any shape where only the size of an energy matters.

#include <Eigen/Dense>

namespace quadrille::stiffness {

struct Equilateral {
  Eigen::VectorXd root_diagonal;  ///< the roots of the diagonal of its Schur complement: roots of the modes' energies
  Eigen::MatrixXd extension;      ///< column: orthogonal coefficients of the least energy for a boundary mode
};

/// Of order >= 1; computed once.
const Equilateral& equilateral(int order);

}  // namespace quadrille::stiffness
