#pragma once
// Static condensation: an element's interior modes eliminated (Karniadakis and Sherwin, sec. 4.1.6).

#include <Eigen/Dense>

namespace quadrille::galerkin {

struct CondensedElement {
  Eigen::MatrixXd schur;                   ///< K_bb - K_bi K_ii^-1 K_ib, over the boundary modes
  Eigen::MatrixXd interior_from_boundary;  ///< -K_ii^-1 K_ib: interior coefficients of the least energy
};

/// `stiffness` has the modified basis' sequence: boundary modes first. Throws ComputeError when K_ii is not positive
/// definite, which only an element with folded shape can cause.
CondensedElement condense(int order, const Eigen::MatrixXd& stiffness);

}  // namespace quadrille::galerkin
