#pragma once
// Continuous Galerkin: modified hierarchical basis, minimum rule on edges, interior modes condensed.

#include <memory>

#include "base/stopwatch.hpp"
#include "galerkin/dirichlet.hpp"
#include "galerkin/discretization.hpp"
#include "galerkin/sparse_solver.hpp"
#include "stiffness/condensed_element.hpp"

namespace quadrille::galerkin {

/// The condensed Laplace system on one mesh: factored once for each order map, solved for any boundary values. Each
/// column of a matrix is one function.
class ContinuousSystem {
 public:
  /// The numbers kept by default for the solution inside elements, 0.5 GiB.
  static constexpr std::size_t default_kept_numbers = std::size_t{1} << 26;
  /// `context` must outlive this. What determines the solution inside an element is kept up to `kept_numbers`,
  /// and computed again beyond that, each time that it is asked for; the results are the same.
  explicit ContinuousSystem(const MeshContext& context, int num_threads = 1,
                            std::size_t kept_numbers = default_kept_numbers);
  /// Recomputes the matrices of elements whose order has changed, and factors the system. Throws ComputeError if the
  /// factorisation breaks down.
  void set_orders(const std::vector<int>& elem_order, Stopwatch& watch);
  /// The dof numbers. This and all members below require set_orders().
  const DofMap& map() const { return *map_; }
  const std::vector<int>& elem_order() const { return elem_order_; }
  /// All dofs (num_dofs rows) from the values of the given ones, [num_unknowns, num_dofs).
  Eigen::MatrixXd solve(const Eigen::MatrixXd& given, Stopwatch& watch);
  /// Energy products of the solutions for many given values that are sparse, without the solutions.
  Eigen::MatrixXd energy_products(const SparseColumns& given) const;
  /// Residual of the last solve, relative to its right-hand side.
  double residual() const { return residual_; }
  /// The reactions of the given dofs (galerkin/condensed_system.hpp).
  Eigen::MatrixXd reactions(const Eigen::MatrixXd& dofs) const;
  /// The coefficients of one element in the orthogonal basis.
  Eigen::MatrixXd coefs(int elem, const Eigen::MatrixXd& dofs) const;
  /// coefs() of all elements.
  std::vector<Eigen::MatrixXd> all_coefs(const Eigen::MatrixXd& dofs) const;
  /// Size of the condensed system for this order map.
  int num_unknowns(const std::vector<int>& elem_order) const;

 private:
  void update_elements(const std::vector<int>& elem_order);
  CondensedElement computed_element(int elem) const;
  Eigen::MatrixXd coefs(int elem, const Eigen::MatrixXd& dofs, const CondensedElement& element) const;

  const MeshContext* context_;
  int num_threads_;
  std::size_t kept_numbers_;
  std::vector<int> elem2shape_;  ///< first_of_shape()
  std::vector<int> elem_order_;  ///< of elements_; 0 before the first solve
  CondensedElements elements_;
  std::unique_ptr<DofMap> map_;
  std::unique_ptr<SparseSolver> solver_;  ///< of map_
  double residual_ = 0;
};

/// The continuous discretisation of both Laplace problems.
class ContinuousGalerkin : public Discretization {
 public:
  /// `data` must be continuous around every loop. `context` must outlive this.
  ContinuousGalerkin(const MeshContext& context, BoundaryData data, int num_threads = 1);
  Solution solve(const std::vector<int>& elem_order) override;
  int num_unknowns(const std::vector<int>& elem_order) const override { return system_.num_unknowns(elem_order); }

 private:
  const MeshContext* context_;
  ContinuousSystem system_;
  DirichletData dirichlet_;
};

}  // namespace quadrille::galerkin
