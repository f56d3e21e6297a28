#pragma once
// Discontinuous Galerkin in hybridised form, by the interior penalty method (Cockburn, Gopalakrishnan and Lazarov 2009,
// "IP-H"): unknowns on edges only. Boundary data are imposed weakly and may therefore jump at a corner.
//
// Unknowns: u of degree P inside, the trace lambda on the three edges. For all w and mu
//   int grad u . grad w - int_dT (d_n u) (w - mu) - int_dT (d_n w) (u - lambda) + int_dT tau (u - lambda) (w - mu) = 0,
// summed over the elements; lambda is common to both elements of an edge, so that the fluxes of neighbours agree
// weakly. u is eliminated element by element. The form is definite for tau = penalty * P (P + 1) / 2 * |dT| / |T| with
// penalty > 1 (Warburton and Hesthaven 2003).

#include <Eigen/Dense>
#include <array>

#include "galerkin/condensed_system.hpp"
#include "galerkin/dirichlet.hpp"
#include "galerkin/discretization.hpp"
#include "spectral/tri_map.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::galerkin {

/// Number of trace modes of an edge: Legendre polynomials of degree 0..order, scaled to norm 1 on [-1, 1].
constexpr int num_trace_modes(int order) { return order + 1; }

/// Values of the trace modes at s in [-1, 1]: writes order + 1 numbers.
void trace_values(int order, double s, double* values);

/// The element's Schur complement over the trace modes of its edges 0, 1, 2, each directed counter-clockwise;
/// `interior` gives all modes of u (modified basis). `stiffness`: of the modified basis
/// of degree `order` >= 1. Throws ComputeError if the form is not definite, which only a folded element can cause.
stiffness::CondensedElement condense_to_trace(const spectral::TriMap& map, int order,
                                              const std::array<int, 3>& edge_orders, const Eigen::MatrixXd& stiffness,
                                              double penalty);

/// Boundary data, projected on each edge separately, so that they may jump where two edges meet: values of the trace
/// dofs [num_unknowns, num_dofs), columns u, v, the L2 projection along each edge. The point at
/// fraction s of an edge lies at fraction s of the curve's arc length. The data are never evaluated at the ends of an
/// edge.
Eigen::MatrixXd trace_data(const TriMesh& mesh, const mesh::TriTopology& topology, const DofMap& map,
                           const BoundaryData& data);

/// The hybridised discontinuous discretisation of both Laplace problems.
class HybridisedGalerkin : public Discretization {
 public:
  /// `context` must outlive this. `penalty` > 1, see above.
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
