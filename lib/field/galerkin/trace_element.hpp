#pragma once
// One element of the hybridised interior penalty method (Cockburn, Gopalakrishnan and Lazarov 2009, "IP-H").
//
// Unknowns: u of degree P inside, the trace lambda on the three edges. For all w and mu
//   int grad u . grad w - int_dT (d_n u) (w - mu) - int_dT (d_n w) (u - lambda) + int_dT tau (u - lambda) (w - mu) = 0,
// summed over the elements; lambda is common to both elements of an edge, so that the fluxes of neighbours agree
// weakly. u is eliminated element by element. The form is definite for tau = penalty * P (P + 1) / 2 * |dT| / |T| with
// penalty > 1 (Warburton and Hesthaven 2003).

#include <Eigen/Dense>
#include <array>

#include "spectral/tri_map.hpp"
#include "stiffness/condense.hpp"

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

}  // namespace quadrille::galerkin
