#pragma once
// The global system of the condensed elements, evaluated element by element: the sum K of their Schur complements over
// the free dofs, and the right-hand side from the given (boundary) dofs. Each column of a matrix is one function.

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <vector>

#include "galerkin/dof_map.hpp"
#include "stiffness/condense.hpp"

namespace quadrille::galerkin {

using stiffness::CondensedElement;
using stiffness::CondensedElements;

/// The right-hand side, num_unknowns rows: minus the reactions of `given`, the values of the dofs [num_unknowns,
/// num_dofs).
Eigen::MatrixXd right_hand_side(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& given);

/// Many functions with few values each, one per column; stored by row.
using SparseColumns = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Given values as the system receives them.
struct SparseData {
  SparseColumns rhs;        ///< as right_hand_side()
  Eigen::MatrixXd product;  ///< the energy products of the functions that are 0 in all free dofs
};
SparseData sparse_data(const DofMap& map, const CondensedElements& elements, const SparseColumns& given);

/// The coefficients of the boundary modes of one element; 0 for modes without a dof.
Eigen::MatrixXd element_dofs(const DofMap& map, int elem, const Eigen::MatrixXd& dofs);

/// The rows of the given dofs of the full matrix, multiplied by `dofs` (all dofs). If the free dofs solve the system,
/// the energy product a(f, g) of two columns is (given part of f) . (reaction of g).
Eigen::MatrixXd reactions(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& dofs);

/// |rhs - K x| / |rhs|; |rhs - K x| if the right-hand side is 0. `dofs` contains all dofs: x, then the given ones.
double relative_residual(const DofMap& map, const CondensedElements& elements, const Eigen::MatrixXd& rhs,
                         const Eigen::MatrixXd& dofs);

}  // namespace quadrille::galerkin
