#pragma once
// Stiffness matrices K_mn = int grad psi_m . grad psi_n over one element, psi the modified basis.

#include <Eigen/Dense>

#include "spectral/tri_map.hpp"

namespace quadrille::galerkin {

/// Affine elements combine three reference matrices, made once per order. Curved ones are integrated by a collapsed
/// Gauss rule with `extra_points` more than the order in each direction: the integrand is not a polynomial there.
Eigen::MatrixXd stiffness_matrix(const spectral::TriMap& map, int order, int extra_points = 6);

/// The matrix of a lower order, cut out of that of `higher_order`: the basis is hierarchical.
Eigen::MatrixXd cut_down(const Eigen::MatrixXd& stiffness, int higher_order, int order);

}  // namespace quadrille::galerkin
