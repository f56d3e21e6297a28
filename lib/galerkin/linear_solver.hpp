#pragma once
// The sparse symmetric positive definite system of the condensed elements, by the multifrontal method (Duff and Reid
// 1983; Liu 1992): along an elimination tree, dense matrices of one part of the mesh after the other, the unknowns inside
// eliminated, the rest handed on to the part that holds it. The sparse matrix itself is never made.

#include <Eigen/Dense>
#include <vector>

#include "galerkin/condense.hpp"
#include "galerkin/dof_map.hpp"
#include "galerkin/elimination_tree.hpp"

namespace quadrille {

/// Solves K x = rhs (columns u, v) for the sum K of the elements' Schur complements over the free dofs. `map` numbers
/// them along tree.sequence. Throws ComputeError when K is not positive definite. n^1.5 for n elements, memory n log n.
Eigen::MatrixX2d solve_condensed(const EliminationTree& tree, const DofMap& map,
                                 const std::vector<CondensedElement>& elements, const Eigen::MatrixX2d& rhs,
                                 int num_threads = 1);

}  // namespace quadrille
