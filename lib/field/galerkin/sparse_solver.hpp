#pragma once
// What the discretisations ask of a solver of the condensed system.

#include <Eigen/Dense>
#include <memory>

#include "base/progress.hpp"
#include "galerkin/condensed_system.hpp"
#include "mesh/elimination_tree.hpp"

namespace quadrille::galerkin {

/// The sparse symmetric positive definite system of the condensed elements: the sum of their Schur complements over the
/// free dofs.
class SparseSolver {
 public:
  virtual ~SparseSolver() = default;
  /// Throws ComputeError if the sum is not positive definite.
  virtual void factor(const CondensedElements& elements, Progress* progress = nullptr) = 0;
  /// The solution for each column of `rhs`. Requires factor(); may be called any number of times. Parts of the mesh
  /// without a right-hand side are left out, with zeros, where no column exceeds `negligible` on their boundary.
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs, double negligible = 0) = 0;
  /// b^T A^-1 b for the factored A and many sparse columns b. Requires factor().
  virtual Eigen::MatrixXd inverse_products(const SparseColumns& b) const = 0;
};

// The choice of a solver of the condensed system.

/// The solver of all systems, CondensedCholesky. `map` numbers its free dofs in the order of tree.elimination_order; a
/// solver with an order of its own permutes them inside. Both must outlive the solver.
std::unique_ptr<SparseSolver> make_sparse_solver(const mesh::EliminationTree& tree, const DofMap& map, int num_threads);

}  // namespace quadrille::galerkin
