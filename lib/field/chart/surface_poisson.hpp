#pragma once
// Poisson's equation on the triangles of a curved face: element matrices are condensed once, and serve systems with
// different given dofs.

#include <Eigen/Dense>
#include <vector>

#include "chart/element_forms.hpp"
#include "chart/surface_mesh.hpp"
#include "galerkin/condensed_system.hpp"
#include "mesh/elimination_tree.hpp"
#include "mesh/tri_topology.hpp"

namespace quadrille::chart {

/// By element, the modes of its order; one function a column.
using ElementColumns = std::vector<Eigen::MatrixXd>;

class SurfacePoisson {
 public:
  /// `mesh` and `forms` must outlive this.
  SurfacePoisson(const SurfaceMesh& mesh, const SurfaceForms& forms);

  /// The functions u with int <du, dq> = load(q): for all q that are 0 on loop 0, as u is.
  ElementColumns solve_dirichlet(const ElementColumns& loads, int num_outline_curves) const;
  /// For all q; u = 0 at vertex 0. Loads of q = 1 must vanish.
  ElementColumns solve_neumann(const ElementColumns& loads) const;

 private:
  ElementColumns solve(const ElementColumns& loads, const std::vector<bool>& is_given) const;

  const SurfaceMesh* mesh_;
  mesh::TriTopology topology_;
  mesh::EliminationTree tree_;
  stiffness::CondensedElements elements_;
  std::vector<Eigen::LLT<Eigen::MatrixXd>> interiors_;  ///< of the matrices of interior modes
};

}  // namespace quadrille::chart
