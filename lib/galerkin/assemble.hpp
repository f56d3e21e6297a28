#pragma once
// The global system of the condensed elements.

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <vector>

#include "galerkin/condense.hpp"
#include "galerkin/dof_map.hpp"

namespace quadrille {

struct CondensedSystem {
  Eigen::SparseMatrix<double> matrix;  ///< over the free dofs, lower triangle
  Eigen::MatrixX2d rhs;                ///< columns u, v: minus the given dofs' reactions
};

/// `given`: values of the dofs [num_unknowns, num_dofs), columns u, v.
CondensedSystem assemble(const DofMap& map, const std::vector<CondensedElement>& elements,
                         const Eigen::MatrixX2d& given);

/// The values of an element's own modes, columns u, v; 0 for modes without a dof.
Eigen::MatrixX2d element_dofs(const DofMap& map, int elem, const Eigen::MatrixX2d& dofs);

/// |rhs - matrix x| / |rhs|; |rhs - matrix x| where the right-hand side is 0.
double relative_residual(const CondensedSystem& system, const Eigen::MatrixX2d& x);

}  // namespace quadrille
