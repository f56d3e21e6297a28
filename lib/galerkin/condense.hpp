#pragma once
// Static condensation: eliminates the interior modes of an element (Karniadakis and Sherwin, sec. 4.1.6).

#include <Eigen/Dense>

namespace quadrille::galerkin {

/// An element matrix after elimination of the interior modes i; b are the boundary modes.
struct CondensedElement {
  Eigen::MatrixXd schur;                   ///< K_bb - K_bi K_ii^-1 K_ib, over the boundary modes
  Eigen::MatrixXd interior_from_boundary;  ///< -K_ii^-1 K_ib: interior coefficients of least energy
};

/// `stiffness` is ordered as the modified basis: boundary modes first. Throws ComputeError if K_ii is not positive
/// definite, which only a folded element can cause.
CondensedElement condense(int order, const Eigen::MatrixXd& stiffness);

}  // namespace quadrille::galerkin
