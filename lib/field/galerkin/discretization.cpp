#include "galerkin/discretization.hpp"

#include <fmt/format.h>

#include <atomic>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/parallel.hpp"
#include "galerkin/condensed_system.hpp"
#include "mesh/tri_topology.hpp"
#include "stiffness/condensed_element.hpp"

namespace quadrille::galerkin {

MeshContext::MeshContext(const TriMesh& tri_mesh)
    : mesh(&tri_mesh),
      topology(mesh::tri_topology(tri_mesh)),
      maps(mesh::tri_maps(tri_mesh)),
      tree(mesh::nested_dissection(tri_mesh, topology)) {}

std::string MeshContext::describe(int elem) const {
  const Vec2 x = maps[elem].position({-1.0 / 3, -1.0 / 3}) + mesh->face.origin;
  return fmt::format("element {} near {}", elem, position_text(x));
}

ContinuousSystem::ContinuousSystem(const MeshContext& context, int num_threads, std::size_t kept_numbers)
    : context_(&context),
      num_threads_(num_threads),
      kept_numbers_(kept_numbers),
      elem2shape_(stiffness::first_of_shape(context.maps)),
      elem_order_(context.maps.size(), 0),
      elements_(context.maps.size()) {}

// The matrices of a shape and an order are those of the first element of that shape, whatever its own order is, so that
// they do not depend on the orders solved for before.
void ContinuousSystem::update_elements(const std::vector<int>& elem_order) {
  std::map<std::pair<int, int>, std::shared_ptr<const CondensedElement>> known;  // by shape and order
  const int num_elems = static_cast<int>(elem_order.size());
  std::atomic<std::size_t> kept = 0;
  for (int e = 0; e < num_elems; ++e) {
    if (elements_[e] && known.try_emplace({elem2shape_[e], elem_order_[e]}, elements_[e]).second)
      kept += stiffness::size_of_interior(*elements_[e]);
  }
  std::vector<decltype(known)::value_type*> made;
  for (int e = 0; e < num_elems; ++e) {
    const auto [entry, is_new] = known.try_emplace({elem2shape_[e], elem_order[e]});
    if (is_new) made.push_back(&*entry);
  }
  const Progress::Part part(context_->progress, "elements", static_cast<int>(made.size()));
  parallel_for(static_cast<int>(made.size()), num_threads_, [&](int i) {
    part.advance();
    const auto [elem, order] = made[i]->first;
    try {
      CondensedElement element = stiffness::condensed_element(context_->maps[elem], order);
      const std::size_t size = stiffness::size_of_interior(element);
      if (kept.fetch_add(size) + size > kept_numbers_) element = {std::move(element.schur), {}, {}};
      made[i]->second = std::make_shared<CondensedElement>(std::move(element));
    } catch (const ComputeError& error) {
      throw ComputeError(fmt::format("{}: {}", context_->describe(elem), error.what()));
    }
  });
  for (int e = 0; e < num_elems; ++e) elements_[e] = known.at({elem2shape_[e], elem_order[e]});
  elem_order_ = elem_order;
}

int ContinuousSystem::num_unknowns(const std::vector<int>& elem_order) const {
  return make_dof_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order).num_unknowns;
}

void ContinuousSystem::set_orders(const std::vector<int>& elem_order, Stopwatch& watch) {
  solver_.reset();
  update_elements(elem_order);
  watch.lap("elements");
  map_ = std::make_unique<DofMap>(
      make_dof_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order));
  solver_ = make_sparse_solver(context_->tree, *map_, num_threads_);
  watch.lap("structure");
  solver_->factor(elements_, context_->progress);
  watch.lap("factorisation");
}

Eigen::MatrixXd ContinuousSystem::solve(const Eigen::MatrixXd& given, Stopwatch& watch, double negligible) {
  const Eigen::MatrixXd rhs = right_hand_side(*map_, elements_, given);
  watch.lap("data");
  Eigen::MatrixXd dofs(map_->num_dofs, given.cols());
  dofs << solver_->solve(rhs, negligible), given;
  watch.lap("substitution");
  return dofs;
}

double ContinuousSystem::residual(const Eigen::MatrixXd& dofs) const {
  const Eigen::MatrixXd given = dofs.bottomRows(map_->num_dofs - map_->num_unknowns);
  return relative_residual(*map_, elements_, right_hand_side(*map_, elements_, given), dofs);
}

// Of f = (x, given) with A x = b: the energy is that of (0, given) less b^T A^-1 b.
Eigen::MatrixXd ContinuousSystem::energy_products(const SparseColumns& given) const {
  const SparseData data = sparse_data(*map_, elements_, given);
  const Eigen::MatrixXd products = data.product - solver_->inverse_products(data.rhs);
  return (products + products.transpose()) / 2;
}

Eigen::MatrixXd ContinuousSystem::reactions(const Eigen::MatrixXd& dofs) const {
  return galerkin::reactions(*map_, elements_, dofs);
}

Eigen::MatrixXd ContinuousSystem::coefs(int elem, const Eigen::MatrixXd& dofs, const CondensedElement& element) const {
  return stiffness::element_coefs(context_->maps[elem2shape_[elem]], elem_order_[elem], element,
                                  element_dofs(*map_, elem, dofs));
}

Eigen::MatrixXd ContinuousSystem::coefs(int elem, const Eigen::MatrixXd& dofs) const {
  const CondensedElement& kept = *elements_[elem];
  return kept.has_interior() ? coefs(elem, dofs, kept) : coefs(elem, dofs, computed_element(elem));
}

CondensedElement ContinuousSystem::computed_element(int elem) const {
  return stiffness::condensed_element(context_->maps[elem2shape_[elem]], elem_order_[elem]);
}

std::vector<Eigen::MatrixXd> ContinuousSystem::all_coefs(const Eigen::MatrixXd& dofs) const {
  std::map<std::pair<int, int>, std::vector<int>> elems_by_matrices;  // by shape and order, as they share matrices
  for (int e = 0; e < static_cast<int>(elements_.size()); ++e)
    elems_by_matrices[{elem2shape_[e], elem_order_[e]}].push_back(e);
  std::vector<const std::vector<int>*> groups;
  for (const auto& [matrices, elems] : elems_by_matrices) groups.push_back(&elems);
  std::vector<Eigen::MatrixXd> all(elements_.size());
  parallel_for(static_cast<int>(groups.size()), num_threads_, [&](int i) {
    const int first = groups[i]->front();
    std::optional<CondensedElement> computed;
    if (!elements_[first]->has_interior()) computed = computed_element(first);
    for (const int e : *groups[i]) all[e] = coefs(e, dofs, computed ? *computed : *elements_[e]);
  });
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
  solution.residual = system_.residual(dofs);
  watch.lap("residual");
  solution.elem_coefs = system_.all_coefs(dofs);
  watch.lap("coefficients");
  solution.laps = watch.laps();
  return solution;
}

}  // namespace quadrille::galerkin
