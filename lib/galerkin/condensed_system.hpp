#pragma once
// The global system of the condensed elements, element by element: the sum K of their Schur complements over the free
// dofs, and the right-hand side from the given ones.

#include <Eigen/Dense>
#include <vector>

#include "galerkin/condense.hpp"
#include "galerkin/dof_map.hpp"

namespace quadrille {

/// The right-hand side, columns u, v: minus the reactions of `given`, the values of the dofs [num_unknowns, num_dofs).
Eigen::MatrixX2d right_hand_side(const DofMap& map, const std::vector<CondensedElement>& elements,
                                 const Eigen::MatrixX2d& given);

/// The values of an element's own modes, columns u, v; 0 for modes without a dof.
Eigen::MatrixX2d element_dofs(const DofMap& map, int elem, const Eigen::MatrixX2d& dofs);

/// |rhs - K x| / |rhs|; |rhs - K x| where the right-hand side is 0. `dofs` are all: x, then the given ones.
double relative_residual(const DofMap& map, const std::vector<CondensedElement>& elements, const Eigen::MatrixX2d& rhs,
                         const Eigen::MatrixX2d& dofs);

}  // namespace quadrille
