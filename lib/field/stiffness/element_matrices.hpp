#pragma once
// Stiffness matrices K_mn = int grad psi_m . grad psi_n over one element, psi the modified basis.

#include <Eigen/Dense>

#include "spectral/tri_map.hpp"

namespace quadrille::stiffness {

/// Affine elements combine three reference matrices, computed once per order. Curved elements are integrated by a
/// collapsed Gauss rule with order + `extra_points` points in each direction, because the integrand is rational. Sums
/// are factored (Karniadakis and Sherwin, sec. 4.1): about order^5 operations per element instead of order^6.
Eigen::MatrixXd stiffness_matrix(const spectral::TriMap& map, int order, int extra_points = 6);

/// The matrix of a lower order, extracted from the matrix of `higher_order`: the basis is hierarchical.
Eigen::MatrixXd cut_down(const Eigen::MatrixXd& stiffness, int higher_order, int order);

}  // namespace quadrille::stiffness
