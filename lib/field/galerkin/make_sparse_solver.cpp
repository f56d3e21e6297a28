#include "galerkin/make_sparse_solver.hpp"

#include "galerkin/linear_solver.hpp"

namespace quadrille::galerkin {

std::unique_ptr<SparseSolver> make_sparse_solver(const mesh::EliminationTree& tree, const DofMap& map,
                                                 int num_threads) {
  return std::make_unique<CondensedCholesky>(tree, map, num_threads);
}

}  // namespace quadrille::galerkin
