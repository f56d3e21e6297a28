#include "chart/surface_poisson.hpp"

#include <memory>
#include <utility>

#include "galerkin/sparse_solver.hpp"
#include "spectral/modified_basis.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::chart {

SurfacePoisson::SurfacePoisson(const SurfaceMesh& mesh, const SurfaceForms& forms)
    : mesh_(&mesh), topology_(mesh::tri_topology(mesh.plane)), tree_(mesh::nested_dissection(mesh.plane, topology_)) {
  const ElementTables& tables = element_tables(mesh.order);
  const int ni = spectral::num_interior_modes(mesh.order);
  for (const ElementForms& elem : forms.elems) {
    const Eigen::MatrixXd matrix = stiffness_matrix(tables, elem);
    elements_.push_back(std::make_shared<stiffness::CondensedElement>(stiffness::condense(mesh.order, matrix)));
    interiors_.emplace_back(matrix.bottomRightCorner(ni, ni));
  }
}

ElementColumns SurfacePoisson::solve(const ElementColumns& loads, const std::vector<bool>& is_given) const {
  const std::vector<int> orders(elements_.size(), mesh_->order);
  const galerkin::DofMap map =
      galerkin::make_dof_map(mesh_->plane, topology_, tree_.elimination_order, orders, is_given);
  const auto solver = galerkin::make_sparse_solver(tree_, map, 1);
  solver->factor(elements_);
  const int nb = spectral::num_boundary_modes(mesh_->order), ni = spectral::num_interior_modes(mesh_->order);
  const Eigen::Index columns = loads.front().cols();
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(map.num_unknowns, columns);
  for (std::size_t e = 0; e < loads.size(); ++e) {
    const Eigen::MatrixXd load = loads[e].topRows(nb) + elements_[e]->interior->transpose() * loads[e].bottomRows(ni);
    for (int i = 0; i < nb; ++i) {
      const int at = map.elem2offset[e] + i, dof = map.elem2dofs[at];
      if (dof < map.num_unknowns) rhs.row(dof) += map.elem2signs[at] * load.row(i);
    }
  }
  Eigen::MatrixXd dofs = Eigen::MatrixXd::Zero(map.num_dofs, columns);
  dofs.topRows(map.num_unknowns) = solver->solve(rhs);
  ElementColumns modes;
  for (std::size_t e = 0; e < loads.size(); ++e) {
    const Eigen::MatrixXd boundary = galerkin::element_dofs(map, static_cast<int>(e), dofs);
    Eigen::MatrixXd all(nb + ni, columns);
    all.topRows(nb) = boundary;
    all.bottomRows(ni) = *elements_[e]->interior * boundary;
    if (ni > 0) all.bottomRows(ni) += interiors_[e].solve(loads[e].bottomRows(ni));
    modes.push_back(std::move(all));
  }
  return modes;
}

ElementColumns SurfacePoisson::solve_dirichlet(const ElementColumns& loads, int num_outline_curves) const {
  const std::size_t num_vertices = mesh_->plane.vertices.size();
  std::vector<bool> is_given(num_vertices + topology_.edge2vertices.size(), false);
  for (const BoundaryEdge& b : mesh_->plane.boundary_edges) {
    if (b.curve >= num_outline_curves) continue;
    is_given[num_vertices + topology_.elem2edges[b.elem][b.edge]] = true;
    for (const int k : {b.edge, (b.edge + 1) % 3}) is_given[mesh_->plane.elem2vertices[b.elem][k]] = true;
  }
  return solve(loads, is_given);
}

ElementColumns SurfacePoisson::solve_neumann(const ElementColumns& loads) const {
  std::vector<bool> is_given(mesh_->plane.vertices.size() + topology_.edge2vertices.size(), false);
  is_given.front() = true;
  return solve(loads, is_given);
}

}  // namespace quadrille::chart
