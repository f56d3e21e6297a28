#include "galerkin/continuous.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "galerkin/condensed_system.hpp"
#include "galerkin/element_matrices.hpp"
#include "mesh/element_shapes.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::galerkin {

ContinuousSystem::ContinuousSystem(const MeshContext& context, int num_threads)
    : context_(&context),
      num_threads_(num_threads),
      elem2shape_(mesh::first_of_shape(context.maps)),
      elem_order_(context.maps.size(), 0),
      elements_(context.maps.size()) {}

// The matrices of a shape and an order are those of the first element of that shape, whatever its own order is, so that
// they do not depend on the orders solved for before.
void ContinuousSystem::update_elements(const std::vector<int>& elem_order) {
  using Matrices = std::pair<std::pair<int, int>, std::shared_ptr<const CondensedElement>>;  // of a shape and an order
  std::map<std::pair<int, int>, std::shared_ptr<const CondensedElement>> known;
  const int num_elems = static_cast<int>(elem_order.size());
  for (int e = 0; e < num_elems; ++e)
    if (elements_[e]) known[{elem2shape_[e], elem_order_[e]}] = elements_[e];
  std::vector<Matrices> made;
  for (int e = 0; e < num_elems; ++e)
    if (const std::pair key{elem2shape_[e], elem_order[e]}; known.try_emplace(key).second)
      made.emplace_back(key, nullptr);
  const Progress::Part part(context_->progress, "elements", static_cast<int>(made.size()));
  parallel_for(static_cast<int>(made.size()), num_threads_, [&](int i) {
    part.advance();
    const auto [elem, order] = made[i].first;
    try {
      made[i].second =
          std::make_shared<CondensedElement>(condense(order, stiffness_matrix(context_->maps[elem], order)));
    } catch (const ComputeError& error) {
      throw ComputeError(fmt::format("{}: {}", context_->describe(elem), error.what()));
    }
  });
  for (Matrices& matrices : made) known[matrices.first] = std::move(matrices.second);
  for (int e = 0; e < num_elems; ++e) elements_[e] = known.at({elem2shape_[e], elem_order[e]});
  elem_order_ = elem_order;
}

int ContinuousSystem::num_unknowns(const std::vector<int>& elem_order) const {
  return make_dof_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order).num_unknowns;
}

void ContinuousSystem::set_orders(const std::vector<int>& elem_order, Stopwatch& watch) {
  cholesky_.reset();
  update_elements(elem_order);
  watch.lap("elements");
  map_ = std::make_unique<DofMap>(
      make_dof_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order));
  cholesky_ = std::make_unique<CondensedCholesky>(context_->tree, *map_, num_threads_);
  watch.lap("structure");
  cholesky_->factor(elements_, context_->progress);
  watch.lap("factorisation");
}

Eigen::MatrixXd ContinuousSystem::solve(const Eigen::MatrixXd& given, Stopwatch& watch) {
  const Eigen::MatrixXd rhs = right_hand_side(*map_, elements_, given);
  watch.lap("data");
  Eigen::MatrixXd dofs(map_->num_dofs, given.cols());
  dofs << cholesky_->solve(rhs), given;
  watch.lap("substitution");
  residual_ = relative_residual(*map_, elements_, rhs, dofs);
  watch.lap("residual");
  return dofs;
}

Eigen::MatrixXd ContinuousSystem::reactions(const Eigen::MatrixXd& dofs) const {
  return galerkin::reactions(*map_, elements_, dofs);
}

Eigen::MatrixXd ContinuousSystem::modes(int elem, const Eigen::MatrixXd& dofs) const {
  const int order = elem_order_[elem], nb = spectral::num_boundary_modes(order);
  Eigen::MatrixXd modes(spectral::num_tri_modes(order), dofs.cols());
  modes.topRows(nb) = element_dofs(*map_, elem, dofs);
  modes.bottomRows(spectral::num_interior_modes(order)) = elements_[elem]->interior(modes.topRows(nb));
  return modes;
}

std::vector<Eigen::MatrixXd> ContinuousSystem::all_modes(const Eigen::MatrixXd& dofs) const {
  std::vector<Eigen::MatrixXd> all(elements_.size());
  parallel_for(static_cast<int>(all.size()), num_threads_, [&](int e) { all[e] = modes(e, dofs); });
  return all;
}

ContinuousGalerkin::ContinuousGalerkin(const MeshContext& context, BoundaryData data, int num_threads)
    : context_(&context), system_(context, num_threads), dirichlet_(*context.mesh, std::move(data)) {}

Solution ContinuousGalerkin::solve(const std::vector<int>& elem_order) {
  Stopwatch watch;
  system_.set_orders(elem_order, watch);
  const Eigen::MatrixXd dofs = system_.solve(dirichlet_.values(context_->topology, system_.map()), watch);
  Solution solution;
  solution.num_unknowns = system_.map().num_unknowns;
  solution.residual = system_.residual();
  solution.elem_coefs = system_.all_modes(dofs);
  watch.lap("coefficients");
  solution.laps = watch.laps();
  return solution;
}

}  // namespace quadrille::galerkin
