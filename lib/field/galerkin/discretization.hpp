#pragma once
// Discretisations of the Laplace problems: one mesh, prepared once, and solutions for successive order maps on it. The
// common interface, and continuous Galerkin: modified hierarchical basis, minimum rule on edges, interior modes
// condensed.

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/stopwatch.hpp"
#include "field/alignment_term.hpp"
#include "galerkin/dirichlet.hpp"
#include "galerkin/sparse_solver.hpp"
#include "mesh/elimination_tree.hpp"
#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"
#include "stiffness/element_matrices.hpp"
#include "stiffness/screened_element.hpp"

namespace quadrille::galerkin {

/// A mesh with all derived data that do not depend on the order map.
struct MeshContext {
  explicit MeshContext(const TriMesh& mesh);  ///< `mesh` must outlive the context

  const TriMesh* mesh;
  mesh::TriTopology topology;
  std::vector<spectral::TriMap> maps;
  mesh::EliminationTree tree;
  Progress* progress = nullptr;  ///< of the computations on this mesh, as long as it exists

  /// "element 7 near (0.5, 0.25)", in the user's coordinates.
  std::string describe(int elem) const;
};

/// The solution of both Laplace problems for one order map.
struct Solution {
  std::vector<Eigen::MatrixXd> elem_coefs;  ///< orthogonal basis of the element's order, columns u, v
  int num_unknowns = 0;                     ///< of the condensed system
  double residual = 0;                      ///< of the condensed system, |rhs - K x| / |rhs|
  std::vector<Lap> laps;                    ///< time of each phase of the solution
};

/// A method that solves both Laplace problems on one mesh.
class Discretization {
 public:
  virtual ~Discretization() = default;
  /// Solves with order elem_order[e] on element e. Throws ComputeError if the factorisation breaks down.
  virtual Solution solve(const std::vector<int>& elem_order) = 0;
  /// Size of the condensed system for this order map.
  virtual int num_unknowns(const std::vector<int>& elem_order) const = 0;
};

/// The values of functions at points of one element: a row per point, a column per function.
using ValuesInElement = std::function<Eigen::MatrixXd(int elem, const std::vector<Vec2>& points)>;

/// Of each element; those without the term mu v have none.
using Loads = std::vector<stiffness::ElementLoad>;

/// The condensed system of Laplace's equation on one mesh, or of -Δv + mu v = f where a term aligns crosses
/// (field/alignment_term): factored once for each order map, solved for any boundary values. Each column of a matrix is
/// one function.
class ContinuousSystem {
 public:
  /// The numbers kept by default for the solution inside elements, 0.5 GiB.
  static constexpr std::size_t default_kept_numbers = std::size_t{1} << 26;
  /// `context` must outlive this. What determines the solution inside an element is kept up to `kept_numbers`,
  /// and computed again beyond that, each time that it is asked for; the results are the same.
  /// `term`: of the equation, must outlive this; null: none.
  explicit ContinuousSystem(const MeshContext& context, int num_threads = 1,
                            std::size_t kept_numbers = default_kept_numbers,
                            const field::AlignmentTerm* term = nullptr);
  /// Recomputes the matrices of elements whose order has changed, and factors the system. Throws ComputeError if the
  /// factorisation breaks down.
  void set_orders(const std::vector<int>& elem_order, Stopwatch& watch);
  /// The dof numbers. This and all members below require set_orders().
  const DofMap& map() const { return *map_; }
  const std::vector<int>& elem_order() const { return elem_order_; }
  /// All dofs (num_dofs rows) from the values of the given ones, [num_unknowns, num_dofs), where they are not
  /// `negligible` (SparseSolver::solve).
  Eigen::MatrixXd solve(const Eigen::MatrixXd& given, Stopwatch& watch, double negligible = 0, const Loads& loads = {});
  /// Of the functions f, which are asked for where mu is not negligible alone.
  Loads loads(const ValuesInElement& f) const;
  /// Whether mu is not negligible somewhere in the element.
  bool has_term(int elem) const { return is_screened_[elem]; }
  /// The points at which loads ask for f, and the values there of a solution, in an element that has the term.
  std::vector<Vec2> points_of(int elem) const;
  Eigen::MatrixXd values_at_points(int elem, const Eigen::MatrixXd& dofs, const Loads& loads) const;
  /// Of functions with these coefficients in the orthogonal basis.
  Eigen::MatrixXd values_of(int elem, const Eigen::MatrixXd& coefs) const;
  /// Energy products of the solutions for many given values that are sparse, without the solutions.
  Eigen::MatrixXd energy_products(const SparseColumns& given) const;
  /// Residual of a solution, relative to the right-hand side of its given dofs.
  double residual(const Eigen::MatrixXd& dofs, const Loads& loads = {}) const;
  /// The reactions of the given dofs (galerkin/condensed_system.hpp).
  Eigen::MatrixXd reactions(const Eigen::MatrixXd& dofs) const;
  /// The coefficients of one element in the orthogonal basis.
  Eigen::MatrixXd coefs(int elem, const Eigen::MatrixXd& dofs, const Loads& loads = {}) const;
  /// coefs() of all elements.
  std::vector<Eigen::MatrixXd> all_coefs(const Eigen::MatrixXd& dofs, const Loads& loads = {}) const;
  /// Size of the condensed system for this order map.
  int num_unknowns(const std::vector<int>& elem_order) const;

 private:
  void update_elements(const std::vector<int>& elem_order);
  void find_screened_elements();
  std::shared_ptr<const CondensedElement> made_element(int elem, int order);
  CondensedElement computed_element(int elem) const;
  Eigen::MatrixXd coefs(int elem, const Eigen::MatrixXd& dofs, const CondensedElement& element) const;
  Eigen::MatrixXd modes_of(int elem, const Eigen::MatrixXd& dofs, const Loads& loads) const;
  void add_loads(const Loads& loads, Eigen::MatrixXd& rhs) const;

  const MeshContext* context_;
  int num_threads_;
  std::size_t kept_numbers_;
  const field::AlignmentTerm* term_;
  std::vector<bool> is_screened_;                                            ///< by element: has the term
  std::vector<std::shared_ptr<const stiffness::ScreenedElement>> screened_;  ///< those; by element
  std::vector<int> elem2shape_;  ///< first_of_shape(), of elements without the term
  std::vector<int> elem_order_;  ///< of elements_; 0 before the first solve
  CondensedElements elements_;
  std::unique_ptr<DofMap> map_;
  std::unique_ptr<SparseSolver> solver_;  ///< of map_
};

/// The continuous discretisation of both Laplace problems.
class ContinuousGalerkin : public Discretization {
 public:
  /// `data` must be continuous around every loop. `context` and `term` must outlive this; `f`: of the term.
  ContinuousGalerkin(const MeshContext& context, BoundaryData data, int num_threads = 1,
                     const field::AlignmentTerm* term = nullptr, ValuesInElement f = {});
  Solution solve(const std::vector<int>& elem_order) override;
  int num_unknowns(const std::vector<int>& elem_order) const override { return system_.num_unknowns(elem_order); }

 private:
  const MeshContext* context_;
  ContinuousSystem system_;
  DirichletData dirichlet_;
  ValuesInElement f_;
};

}  // namespace quadrille::galerkin
