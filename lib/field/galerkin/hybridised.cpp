#include "galerkin/hybridised.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "galerkin/condensed_system.hpp"
#include "galerkin/make_sparse_solver.hpp"
#include "spectral/factored_modes.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::galerkin {

HybridisedGalerkin::HybridisedGalerkin(const MeshContext& context, BoundaryData data, int num_threads, double penalty)
    : context_(&context),
      num_threads_(num_threads),
      data_(std::move(data)),
      penalty_(penalty),
      orders_(context.maps.size(), Orders{}),
      elements_(context.maps.size()) {}

void HybridisedGalerkin::update_elements(const std::vector<int>& elem_order, const DofMap& map) {
  const Progress::Part part(context_->progress, "elements", static_cast<int>(elem_order.size()));
  parallel_for(static_cast<int>(elem_order.size()), num_threads_, [&](int e) {
    part.advance();
    const auto& edges = context_->topology.elem2edges[e];
    const std::array<int, 3> edge_orders{map.edge2order[edges[0]], map.edge2order[edges[1]], map.edge2order[edges[2]]};
    const Orders orders{elem_order[e], edge_orders[0], edge_orders[1], edge_orders[2]};
    if (orders == orders_[e]) return;
    try {
      const spectral::TriMap& shape = context_->maps[e];
      elements_[e] = std::make_shared<stiffness::CondensedElement>(condense_to_trace(
          shape, elem_order[e], edge_orders, stiffness::stiffness_matrix(shape, elem_order[e]), penalty_));
    } catch (const ComputeError& error) {
      throw ComputeError(fmt::format("{}: {}", context_->describe(e), error.what()));
    }
    orders_[e] = orders;
  });
}

int HybridisedGalerkin::num_unknowns(const std::vector<int>& elem_order) const {
  return make_trace_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order).num_unknowns;
}

Solution HybridisedGalerkin::solve(const std::vector<int>& elem_order) {
  Stopwatch watch;
  const DofMap map = make_trace_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order);
  update_elements(elem_order, map);
  watch.lap("elements");
  const Eigen::MatrixXd given = trace_data(*context_->mesh, context_->topology, map, data_);
  const Eigen::MatrixXd rhs = right_hand_side(map, elements_, given);
  watch.lap("data");
  const std::unique_ptr<SparseSolver> solver = make_sparse_solver(context_->tree, map, num_threads_);
  watch.lap("structure");
  solver->factor(elements_, context_->progress);
  watch.lap("factorisation");
  Eigen::MatrixXd dofs(map.num_dofs, 2);
  dofs << solver->solve(rhs), given;
  watch.lap("substitution");

  Solution solution;
  solution.num_unknowns = map.num_unknowns;
  solution.residual = relative_residual(map, elements_, rhs, dofs);
  watch.lap("residual");
  solution.elem_coefs.resize(elements_.size());
  parallel_for(static_cast<int>(elements_.size()), num_threads_, [&](int e) {
    solution.elem_coefs[e] = spectral::modified_to_orthogonal(elem_order[e]).transpose() * *elements_[e]->interior *
                             element_dofs(map, e, dofs);
  });
  watch.lap("coefficients");
  solution.laps = watch.laps();
  return solution;
}

}  // namespace quadrille::galerkin
