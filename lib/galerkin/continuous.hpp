#pragma once
// Continuous Galerkin: modified hierarchical basis, minimum rule on edges, interior modes condensed.

#include "galerkin/condense.hpp"
#include "galerkin/dirichlet.hpp"
#include "galerkin/discretization.hpp"

namespace quadrille {

class ContinuousGalerkin : public Discretization {
 public:
  /// Data must be continuous around every loop. `context` must outlive this.
  ContinuousGalerkin(const MeshContext& context, BoundaryData data, int num_threads = 1);
  Solution solve(const std::vector<int>& elem_order) override;
  int num_unknowns(const std::vector<int>& elem_order) const override;

 private:
  void update_elements(const std::vector<int>& elem_order);

  const MeshContext* context_;
  int num_threads_;
  StiffnessTable stiffness_;
  DirichletData dirichlet_;
  std::vector<int> elem_order_;  ///< of elements_; 0 before the first solve
  std::vector<CondensedElement> elements_;
};

}  // namespace quadrille
