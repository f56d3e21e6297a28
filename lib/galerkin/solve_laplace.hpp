#pragma once
// Both Laplace problems of the guiding field (paper, eq. 4) by continuous Galerkin: modified hierarchical basis on
// triangles, minimum rule on edges, static condensation, one sparse Cholesky factorisation for u and v.

#include <vector>

#include "base/report.hpp"
#include "galerkin/condense.hpp"
#include "galerkin/dirichlet.hpp"
#include "mesh/tri_topology.hpp"
#include "model/field.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille {

/// Solves on `mesh` with order elem_order[e] on element e, data and liftings from mesh.face. Linear in the number of
/// elements but for the sparse factorisation. Throws ComputeError when the factorisation breaks down and
/// for a line field (field/boundary_values.hpp).
Field solve_laplace(const TriMesh& mesh, const std::vector<int>& elem_order, Report& report);

/// The same for a sequence of order maps on one mesh: elements whose order has not changed keep their matrices.
class LaplaceSolver {
 public:
  /// The guiding field's own data, liftings subtracted. `mesh` must outlive the solver.
  explicit LaplaceSolver(const TriMesh& mesh);
  /// Any continuous data.
  LaplaceSolver(const TriMesh& mesh, BoundaryData data);
  Field solve(const std::vector<int>& elem_order, Report& report);
  /// Size of the condensed system for this order map.
  int num_unknowns(const std::vector<int>& elem_order) const;

 private:
  LaplaceSolver(const TriMesh& mesh, const std::vector<Lifting>& liftings);
  LaplaceSolver(const TriMesh& mesh, std::vector<Lifting> liftings, BoundaryData data);
  Eigen::MatrixXd stiffness(int elem, int order);
  void update_elements(const std::vector<int>& elem_order);

  const TriMesh* mesh_;
  TriTopology topology_;
  std::vector<int> sequence_;  ///< of elimination (galerkin/dof_map.hpp)
  std::vector<TriMap> maps_;
  std::vector<Lifting> liftings_;
  DirichletData dirichlet_;
  std::vector<int> elem_order_;  ///< of elements_; 0 before the first solve
  std::vector<CondensedElement> elements_;
  /// A curved element's integrals are dear: they are made for table_order(order) and cut down.
  struct Integrals {
    int order = 0;
    Eigen::MatrixXd stiffness;
  };
  std::vector<Integrals> curved_integrals_;
};

}  // namespace quadrille
