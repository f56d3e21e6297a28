#include "galerkin/solve_laplace.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "field/boundary_values.hpp"
#include "field/corner_lifting.hpp"
#include "galerkin/assemble_cg.hpp"
#include "galerkin/element_matrices.hpp"
#include "galerkin/linear_solver.hpp"
#include "mesh/tri_maps.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille {

namespace {

// Coefficients of one element in the orthogonal basis, columns u, v, from all dofs.
Eigen::MatrixX2d element_coefs(const DofMap& map, const CondensedElement& element, int elem, int order,
                               const Eigen::MatrixX2d& dofs) {
  const int nb = num_boundary_modes(order), offset = map.elem2offset[elem];
  Eigen::MatrixX2d modified = Eigen::MatrixX2d::Zero(num_tri_modes(order), 2);
  for (int i = 0; i < nb; ++i) {
    const int dof = map.elem2dofs[offset + i];
    if (dof >= 0) modified.row(i) = map.elem2signs[offset + i] * dofs.row(dof);
  }
  modified.bottomRows(num_interior_modes(order)) = element.interior_from_boundary * modified.topRows(nb);
  return modified_to_orthogonal(order).transpose() * modified;
}

double relative_residual(const CgSystem& system, const Eigen::MatrixX2d& x) {
  if (x.rows() == 0) return 0;
  const Eigen::MatrixX2d residual = system.rhs - system.matrix.selfadjointView<Eigen::Lower>() * x;
  const double scale = system.rhs.norm();
  return scale > 0 ? residual.norm() / scale : residual.norm();
}

// An element for a message, with its place in the user's coordinates.
std::string describe(const TriMesh& mesh, const std::vector<TriMap>& maps, int elem) {
  const Vec2 x = maps[elem].position({-1.0 / 3, -1.0 / 3}) + mesh.face.origin;
  return fmt::format("element {} near ({:.6g}, {:.6g})", elem, x.x, x.y);
}

}  // namespace

LaplaceSolver::LaplaceSolver(const TriMesh& mesh, std::vector<Lifting> liftings, BoundaryData data)
    : mesh_(&mesh),
      topology_(tri_topology(mesh)),
      sequence_(fill_reducing_sequence(mesh, topology_)),
      maps_(tri_maps(mesh)),
      liftings_(std::move(liftings)),
      dirichlet_(mesh, std::move(data)),
      elem_order_(mesh.num_elems(), 0),
      elements_(mesh.num_elems()),
      curved_integrals_(mesh.num_elems()) {}

LaplaceSolver::LaplaceSolver(const TriMesh& mesh, BoundaryData data) : LaplaceSolver(mesh, {}, std::move(data)) {}

LaplaceSolver::LaplaceSolver(const TriMesh& mesh, const std::vector<Lifting>& liftings)
    : LaplaceSolver(mesh, liftings, [&face = mesh.face, liftings](int curve, double t) {
        return lifted_boundary_value(face, liftings, curve, t);
      }) {}

LaplaceSolver::LaplaceSolver(const TriMesh& mesh) : LaplaceSolver(mesh, corner_liftings(mesh.face)) {
  if (!is_line_field(mesh.face)) return;
  throw ComputeError(
      "all sides are straight and at multiples of 45 degrees to each other, of both parities: the guiding field "
      "vanishes on curves instead of at points, and gives no block layout");
}

Eigen::MatrixXd LaplaceSolver::stiffness(int elem, int order) {
  if (maps_[elem].is_affine()) return stiffness_matrix(maps_[elem], order);
  Integrals& integrals = curved_integrals_[elem];
  const int higher = table_order(order);
  if (integrals.order != higher) integrals = {higher, stiffness_matrix(maps_[elem], higher)};
  return cut_down(integrals.stiffness, higher, order);
}

void LaplaceSolver::update_elements(const std::vector<int>& elem_order) {
  if (elem_order.size() != elem_order_.size()) throw Defect("the order map does not fit the mesh");
  for (std::size_t e = 0; e < elem_order.size(); ++e) {
    if (elem_order[e] == elem_order_[e]) continue;
    const int elem = static_cast<int>(e);
    try {
      elements_[e] = condense(elem_order[e], stiffness(elem, elem_order[e]));
    } catch (const ComputeError& error) {
      throw ComputeError(fmt::format("{}: {}", describe(*mesh_, maps_, elem), error.what()));
    }
    elem_order_[e] = elem_order[e];
  }
}

int LaplaceSolver::num_unknowns(const std::vector<int>& elem_order) const {
  return make_dof_map(*mesh_, topology_, sequence_, elem_order).num_unknowns;
}

Field LaplaceSolver::solve(const std::vector<int>& elem_order, Report& report) {
  update_elements(elem_order);
  const DofMap map = make_dof_map(*mesh_, topology_, sequence_, elem_order);
  const Eigen::MatrixX2d given = dirichlet_.values(topology_, map);
  const CgSystem system = assemble_cg(map, elements_, given);
  Eigen::MatrixX2d dofs(map.num_dofs, 2);
  dofs << solve_symmetric(system.matrix, system.rhs), given;

  Field field;
  field.provenance = mesh_->provenance;
  field.mesh = *mesh_;
  field.elem_order = elem_order;
  field.liftings = liftings_;
  field.coef_offsets.push_back(0);
  for (int e = 0; e < mesh_->num_elems(); ++e) {
    const Eigen::MatrixX2d coefs = element_coefs(map, elements_[e], e, elem_order[e], dofs);
    field.u.insert(field.u.end(), coefs.col(0).begin(), coefs.col(0).end());
    field.v.insert(field.v.end(), coefs.col(1).begin(), coefs.col(1).end());
    field.coef_offsets.push_back(static_cast<int>(field.u.size()));
  }
  report.set("solve.num_elements", mesh_->num_elems());
  report.set("solve.num_unknowns", map.num_unknowns);
  report.set("solve.num_liftings", liftings_.size());
  const double residual = relative_residual(system, dofs.topRows(map.num_unknowns));
  if (!std::isfinite(residual)) throw ComputeError("the solution is not finite: some element has a folded shape");
  report.set("solve.residual", residual);
  return field;
}

Field solve_laplace(const TriMesh& mesh, const std::vector<int>& elem_order, Report& report) {
  return LaplaceSolver(mesh).solve(elem_order, report);
}

}  // namespace quadrille
