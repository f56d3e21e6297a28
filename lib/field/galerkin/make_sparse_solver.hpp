#pragma once
// The choice of a solver of the condensed system.

#include <memory>

#include "galerkin/dof_map.hpp"
#include "galerkin/sparse_solver.hpp"
#include "mesh/elimination_tree.hpp"

namespace quadrille::galerkin {

/// The solver of all systems, CondensedCholesky. `map` numbers its free dofs in the order of tree.elimination_order; a
/// solver with an order of its own permutes them inside. Both must outlive the solver.
std::unique_ptr<SparseSolver> make_sparse_solver(const mesh::EliminationTree& tree, const DofMap& map, int num_threads);

}  // namespace quadrille::galerkin
