#pragma once
// The sparse symmetric positive definite system of the condensed elements, by the multifrontal method (Duff and Reid
// 1983; Liu 1992): along an elimination tree, each part of the mesh has a dense matrix; the unknowns inside the part
// are eliminated, and the Schur complement is passed to the parent. The sparse matrix is never assembled.

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "galerkin/dof_map.hpp"
#include "galerkin/partial_cholesky.hpp"
#include "galerkin/sparse_solver.hpp"
#include "mesh/elimination_tree.hpp"

namespace quadrille::galerkin {

/// Cholesky factorisation of the sum of the elements' Schur complements over the free dofs. The result does not depend
/// on the number of threads. For n elements: time n^1.5, memory n log n.
class CondensedCholesky : public SparseSolver {
 public:
  /// Symbolic factorisation. `map` numbers its dofs in the order of tree.elimination_order; both must outlive this.
  CondensedCholesky(const mesh::EliminationTree& tree, const DofMap& map, int num_threads = 1);
  void factor(const CondensedElements& elements, Progress* progress = nullptr) override;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) override;
  /// Each column is carried only through the parts of the mesh between its entries and the whole.
  Eigen::MatrixXd inverse_products(const SparseColumns& b) const override;

 private:
  /// A part of the mesh: the dofs eliminated with it, then the dofs shared with the rest of the mesh, both ascending.
  struct Part {
    std::vector<int> dofs;
    int num_eliminated = 0;
    std::vector<int> positions_in_parent;  ///< of the shared dofs in the parent's dofs
    Front front;                           ///< the panel is kept, the rest is added to the parent
    Eigen::MatrixXd values;                ///< over dofs: right-hand side, then solution
    int num_shared() const { return static_cast<int>(dofs.size()) - num_eliminated; }
    /// Proportional to the operations of its elimination.
    long long work() const { return static_cast<long long>(num_eliminated) * dofs.size() * dofs.size(); }
  };
  void find_dofs();
  void find_positions_in_parent();
  void divide_work();
  void add_elements(const CondensedElements& elements, int node);
  void add_half(Part& half, Part& part);
  void factor_part(const CondensedElements& elements, int node, int num_threads);
  void substitute_forward(const Eigen::MatrixXd& rhs, int node);
  void substitute_back(Eigen::MatrixXd& solution, int node);
  /// Columns that have values in a part of the mesh, ascending, and their values over the part's dofs.
  struct Carried {
    std::vector<int> columns;
    Eigen::MatrixXd values;
  };
  std::vector<int> columns_in_part(const SparseColumns& b, const std::vector<Carried>& carried, int node) const;
  Carried carry(const SparseColumns& b, std::vector<Carried>& carried, int node) const;
  /// Call f(node, threads) for children before parents, and f(node) for parents before children.
  void upwards(const std::function<void(int, int)>& f) const;
  void downwards(const std::function<void(int)>& f) const;

  const mesh::EliminationTree* tree_;
  const DofMap* map_;
  int num_threads_;
  std::vector<Part> parts_;  ///< by node of the tree
  struct Range {
    int begin, end;
  };
  std::vector<Range> subtrees_;           ///< nodes [begin, end): independent of each other
  std::vector<std::vector<int>> levels_;  ///< the nodes above the subtrees, lowest level first
};

}  // namespace quadrille::galerkin
