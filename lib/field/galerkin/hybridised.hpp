#pragma once
// Discontinuous Galerkin in hybridised form (galerkin/trace_element.hpp): unknowns on edges only. Boundary data are
// imposed weakly and may therefore jump at a corner.

#include <array>

#include "galerkin/discretization.hpp"
#include "galerkin/trace_data.hpp"
#include "galerkin/trace_element.hpp"

namespace quadrille::galerkin {

/// The hybridised discontinuous discretisation of both Laplace problems.
class HybridisedGalerkin : public Discretization {
 public:
  /// `context` must outlive this. `penalty` > 1, see trace_element.hpp.
  HybridisedGalerkin(const MeshContext& context, BoundaryData data, int num_threads = 1, double penalty = 3);
  Solution solve(const std::vector<int>& elem_order) override;
  int num_unknowns(const std::vector<int>& elem_order) const override;

 private:
  /// The orders on which the matrices of an element depend: its own and those of its three edges.
  using Orders = std::array<int, 4>;
  void update_elements(const std::vector<int>& elem_order, const DofMap& map);

  const MeshContext* context_;
  int num_threads_;
  BoundaryData data_;
  double penalty_;
  std::vector<Orders> orders_;  ///< of elements_; 0 before the first solve
  stiffness::CondensedElements elements_;
};

}  // namespace quadrille::galerkin
