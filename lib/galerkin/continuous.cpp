#include "galerkin/continuous.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "galerkin/condensed_system.hpp"
#include "galerkin/linear_solver.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille {

namespace {

// All modes of one element, columns u, v, from all dofs.
Eigen::MatrixX2d element_modes(const DofMap& map, const CondensedElement& element, int elem, int order,
                               const Eigen::MatrixX2d& dofs) {
  const int nb = num_boundary_modes(order);
  Eigen::MatrixX2d modes(num_tri_modes(order), 2);
  modes.topRows(nb) = element_dofs(map, elem, dofs);
  modes.bottomRows(num_interior_modes(order)) = element.interior_from_boundary * modes.topRows(nb);
  return modes;
}

}  // namespace

ContinuousGalerkin::ContinuousGalerkin(const MeshContext& context, BoundaryData data, int num_threads)
    : context_(&context),
      num_threads_(num_threads),
      stiffness_(context),
      dirichlet_(*context.mesh, std::move(data)),
      elem_order_(context.maps.size(), 0),
      elements_(context.maps.size()) {}

void ContinuousGalerkin::update_elements(const std::vector<int>& elem_order) {
  parallel_for(static_cast<int>(elem_order.size()), num_threads_, [&](int e) {
    if (elem_order[e] == elem_order_[e]) return;
    try {
      elements_[e] = condense(elem_order[e], stiffness_(e, elem_order[e]));
    } catch (const ComputeError& error) {
      throw ComputeError(fmt::format("{}: {}", context_->describe(e), error.what()));
    }
    elem_order_[e] = elem_order[e];
  });
}

int ContinuousGalerkin::num_unknowns(const std::vector<int>& elem_order) const {
  return make_dof_map(*context_->mesh, context_->topology, context_->tree.sequence, elem_order).num_unknowns;
}

Solution ContinuousGalerkin::solve(const std::vector<int>& elem_order) {
  Stopwatch watch;
  update_elements(elem_order);
  watch.lap("elements");
  const DofMap map = make_dof_map(*context_->mesh, context_->topology, context_->tree.sequence, elem_order);
  const Eigen::MatrixX2d given = dirichlet_.values(context_->topology, map);
  const Eigen::MatrixX2d rhs = right_hand_side(map, elements_, given);
  watch.lap("data");
  CondensedCholesky cholesky(context_->tree, map, num_threads_);
  watch.lap("structure");
  cholesky.factor(elements_);
  watch.lap("factorisation");
  Eigen::MatrixX2d dofs(map.num_dofs, 2);
  dofs << cholesky.solve(rhs), given;
  watch.lap("substitution");

  Solution solution;
  solution.num_unknowns = map.num_unknowns;
  solution.residual = relative_residual(map, elements_, rhs, dofs);
  watch.lap("residual");
  solution.elem_coefs.resize(elements_.size());
  parallel_for(static_cast<int>(elements_.size()), num_threads_,
               [&](int e) { solution.elem_coefs[e] = element_modes(map, elements_[e], e, elem_order[e], dofs); });
  watch.lap("coefficients");
  solution.laps = watch.laps();
  return solution;
}

}  // namespace quadrille
