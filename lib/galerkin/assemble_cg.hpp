#pragma once
// The global system of the condensed elements.

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <vector>

#include "galerkin/condense.hpp"
#include "galerkin/dof_map.hpp"

namespace quadrille {

struct CgSystem {
  Eigen::SparseMatrix<double> matrix;  ///< over the free dofs, lower triangle
  Eigen::MatrixX2d rhs;                ///< columns u, v: minus the given dofs' reactions
};

/// `given`: values of the dofs [num_unknowns, num_dofs), columns u, v.
CgSystem assemble_cg(const DofMap& map, const std::vector<CondensedElement>& elements, const Eigen::MatrixX2d& given);

}  // namespace quadrille
