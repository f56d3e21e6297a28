#include "galerkin/discretization.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/parallel.hpp"
#include "field/evaluate.hpp"
#include "galerkin/condensed_system.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/modified_basis.hpp"
#include "stiffness/condensed_element.hpp"
#include "surface/positions.hpp"

namespace quadrille::galerkin {

MeshContext::MeshContext(const TriMesh& tri_mesh)
    : mesh(&tri_mesh),
      topology(mesh::tri_topology(tri_mesh)),
      maps(mesh::tri_maps(tri_mesh)),
      tree(mesh::nested_dissection(tri_mesh, topology)) {}

std::string MeshContext::describe(int elem) const {
  return fmt::format("element {} near {}", elem,
                     surface::position_text(mesh->face, maps[elem].position(field::centroid)));
}

ContinuousSystem::ContinuousSystem(const MeshContext& context, int num_threads, std::size_t kept_numbers,
                                   const field::AlignmentTerm* term)
    : context_(&context),
      num_threads_(num_threads),
      kept_numbers_(kept_numbers),
      term_(term),
      is_screened_(context.maps.size(), false),
      screened_(context.maps.size()),
      elem2shape_(stiffness::first_of_shape(context.maps)),
      elem_order_(context.maps.size(), 0),
      elements_(context.maps.size()) {
  if (term) find_screened_elements();
}

// The matrix of an element with the term depends on its place: it is the only one of its shape.
void ContinuousSystem::find_screened_elements() {
  std::map<int, int> first_without;  // by first of the shape
  for (int e = 0; e < static_cast<int>(elem2shape_.size()); ++e) {
    const spectral::TriMap& map = context_->maps[e];
    const Vec2 centre = map.position(field::centroid);
    is_screened_[e] = term_->acts_in(centre, field::radius_of(map, centre));
    elem2shape_[e] = is_screened_[e] ? e : first_without.try_emplace(elem2shape_[e], e).first->second;
  }
}

std::vector<Vec2> ContinuousSystem::points_of(int elem) const {
  return stiffness::rule_points(context_->maps[elem], elem_order_[elem]);
}

std::shared_ptr<const CondensedElement> ContinuousSystem::made_element(int elem, int order) {
  const spectral::TriMap& map = context_->maps[elem];
  if (!is_screened_[elem]) return std::make_shared<CondensedElement>(stiffness::condensed_element(map, order));
  const std::vector<Vec2> points = stiffness::rule_points(map, order);
  Eigen::VectorXd rate(std::ssize(points));
  for (std::size_t q = 0; q < points.size(); ++q) rate[static_cast<Eigen::Index>(q)] = term_->at(points[q]).rate;
  screened_[elem] = std::make_shared<stiffness::ScreenedElement>(stiffness::screened_element(map, order, rate));
  return {screened_[elem], &screened_[elem]->element};
}

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
      std::shared_ptr<const CondensedElement>& element = made[i]->second = made_element(elem, order);
      const std::size_t size = stiffness::size_of_interior(*element);
      if (kept.fetch_add(size) + size > kept_numbers_ && !is_screened_[elem])
        element = std::make_shared<CondensedElement>(CondensedElement{element->schur, {}, {}});
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

Eigen::MatrixXd ContinuousSystem::solve(const Eigen::MatrixXd& given, Stopwatch& watch, double negligible,
                                        const Loads& loads) {
  Eigen::MatrixXd rhs = right_hand_side(*map_, elements_, given);
  add_loads(loads, rhs);
  watch.lap("data");
  Eigen::MatrixXd dofs(map_->num_dofs, given.cols());
  dofs << solver_->solve(rhs, negligible), given;
  watch.lap("substitution");
  return dofs;
}

Loads ContinuousSystem::loads(const ValuesInElement& f) const {
  Loads loads(elements_.size());
  parallel_for(static_cast<int>(elements_.size()), num_threads_, [&](int e) {
    if (is_screened_[e]) loads[e] = stiffness::element_load(elem_order_[e], *screened_[e], f(e, points_of(e)));
  });
  return loads;
}

void ContinuousSystem::add_loads(const Loads& loads, Eigen::MatrixXd& rhs) const {
  for (std::size_t e = 0; e < loads.size(); ++e) {
    const int offset = map_->elem2offset[e];
    for (Eigen::Index i = 0; i < loads[e].boundary.rows(); ++i) {
      const int dof = map_->elem2dofs[offset + i];
      if (dof >= 0 && dof < map_->num_unknowns) rhs.row(dof) += map_->elem2signs[offset + i] * loads[e].boundary.row(i);
    }
  }
}

double ContinuousSystem::residual(const Eigen::MatrixXd& dofs, const Loads& loads) const {
  const Eigen::MatrixXd given = dofs.bottomRows(map_->num_dofs - map_->num_unknowns);
  const Eigen::MatrixXd of_given = right_hand_side(*map_, elements_, given);
  if (loads.empty()) return relative_residual(*map_, elements_, of_given, dofs);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(map_->num_unknowns, dofs.cols());
  add_loads(loads, load);
  return relative_residual(*map_, elements_, of_given + load, dofs, load);
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

Eigen::MatrixXd ContinuousSystem::modes_of(int elem, const Eigen::MatrixXd& dofs, const Loads& loads) const {
  return stiffness::all_modes(*screened_[elem], loads.at(elem), element_dofs(*map_, elem, dofs));
}

Eigen::MatrixXd ContinuousSystem::values_at_points(int elem, const Eigen::MatrixXd& dofs, const Loads& loads) const {
  return stiffness::values_at_points(elem_order_[elem], modes_of(elem, dofs, loads));
}

Eigen::MatrixXd ContinuousSystem::values_of(int elem, const Eigen::MatrixXd& coefs) const {
  const int order = elem_order_[elem];
  return stiffness::values_at_points(order,
                                     spectral::modified_to_orthogonal(order).transpose().partialPivLu().solve(coefs));
}

Eigen::MatrixXd ContinuousSystem::coefs(int elem, const Eigen::MatrixXd& dofs, const Loads& loads) const {
  if (is_screened_[elem])
    return spectral::modified_to_orthogonal(elem_order_[elem]).transpose() * modes_of(elem, dofs, loads);
  const CondensedElement& kept = *elements_[elem];
  return kept.has_interior() ? coefs(elem, dofs, kept) : coefs(elem, dofs, computed_element(elem));
}

CondensedElement ContinuousSystem::computed_element(int elem) const {
  return stiffness::condensed_element(context_->maps[elem2shape_[elem]], elem_order_[elem]);
}

std::vector<Eigen::MatrixXd> ContinuousSystem::all_coefs(const Eigen::MatrixXd& dofs, const Loads& loads) const {
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
    for (const int e : *groups[i]) all[e] = computed ? coefs(e, dofs, *computed) : coefs(e, dofs, loads);
  });
  return all;
}

ContinuousGalerkin::ContinuousGalerkin(const MeshContext& context, BoundaryData data, int num_threads,
                                       const field::AlignmentTerm* term, ValuesInElement f)
    : context_(&context),
      system_(context, num_threads, ContinuousSystem::default_kept_numbers, term),
      dirichlet_(*context.mesh, std::move(data)),
      f_(std::move(f)) {}

Solution ContinuousGalerkin::solve(const std::vector<int>& elem_order) {
  Stopwatch watch;
  system_.set_orders(elem_order, watch);
  const Loads loads = f_ ? system_.loads(f_) : Loads();
  const Eigen::MatrixXd dofs = system_.solve(dirichlet_.values(context_->topology, system_.map()), watch, 0, loads);
  Solution solution;
  solution.num_unknowns = system_.map().num_unknowns;
  solution.residual = system_.residual(dofs, loads);
  watch.lap("residual");
  solution.elem_coefs = system_.all_coefs(dofs, loads);
  watch.lap("coefficients");
  solution.laps = watch.laps();
  return solution;
}

}  // namespace quadrille::galerkin
