#include "galerkin/hybridised.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "galerkin/assemble.hpp"
#include "galerkin/linear_solver.hpp"

namespace quadrille {

HybridisedGalerkin::HybridisedGalerkin(const MeshContext& context, BoundaryData data, double penalty)
    : context_(&context),
      stiffness_(context),
      data_(std::move(data)),
      penalty_(penalty),
      orders_(context.maps.size(), Orders{}),
      elements_(context.maps.size()) {}

void HybridisedGalerkin::update_elements(const std::vector<int>& elem_order, const DofMap& map) {
  for (std::size_t e = 0; e < elem_order.size(); ++e) {
    const auto& edges = context_->topology.elem2edges[e];
    const std::array<int, 3> edge_orders{map.edge2order[edges[0]], map.edge2order[edges[1]], map.edge2order[edges[2]]};
    const Orders orders{elem_order[e], edge_orders[0], edge_orders[1], edge_orders[2]};
    if (orders == orders_[e]) continue;
    const int elem = static_cast<int>(e);
    try {
      elements_[e] =
          condense_to_trace(context_->maps[e], elem_order[e], edge_orders, stiffness_(elem, elem_order[e]), penalty_);
    } catch (const ComputeError& error) {
      throw ComputeError(fmt::format("{}: {}", context_->describe(elem), error.what()));
    }
    orders_[e] = orders;
  }
}

int HybridisedGalerkin::num_unknowns(const std::vector<int>& elem_order) const {
  return make_trace_map(*context_->mesh, context_->topology, context_->sequence, elem_order).num_unknowns;
}

Solution HybridisedGalerkin::solve(const std::vector<int>& elem_order) {
  const DofMap map = make_trace_map(*context_->mesh, context_->topology, context_->sequence, elem_order);
  update_elements(elem_order, map);
  const Eigen::MatrixX2d given = trace_data(*context_->mesh, context_->topology, map, data_);
  const CondensedSystem system = assemble(map, elements_, given);
  Eigen::MatrixX2d dofs(map.num_dofs, 2);
  dofs << solve_symmetric(system.matrix, system.rhs), given;

  Solution solution;
  solution.num_unknowns = map.num_unknowns;
  solution.residual = relative_residual(system, dofs.topRows(map.num_unknowns));
  for (std::size_t e = 0; e < elements_.size(); ++e)
    solution.elem_coefs.push_back(elements_[e].interior_from_boundary * element_dofs(map, static_cast<int>(e), dofs));
  return solution;
}

}  // namespace quadrille
