#pragma once
// Static condensation: eliminates the interior modes of an element (Karniadakis and Sherwin, sec. 4.1.6).

#include <Eigen/Dense>
#include <memory>
#include <vector>

namespace quadrille::galerkin {

/// An element matrix after elimination of the interior modes i; b are the boundary modes; K_ii = L L^T.
struct CondensedElement {
  Eigen::MatrixXd schur;   ///< K_bb - K_bi K_ii^-1 K_ib, over the boundary modes
  Eigen::MatrixXd factor;  ///< L, in the lower triangle
  Eigen::MatrixXd half;    ///< L^-1 K_ib

  /// -K_ii^-1 K_ib b: the interior coefficients of least energy for boundary coefficients b, one function a column.
  Eigen::MatrixXd interior(const Eigen::MatrixXd& boundary) const;
};

/// Eliminates the interior modes. Throws ComputeError(`failure`) if K_ii is not positive definite.
CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure);

/// The matrices of all elements; those of the same shape and order share one object (mesh/element_shapes.hpp).
using CondensedElements = std::vector<std::shared_ptr<const CondensedElement>>;

/// `stiffness` is ordered as the modified basis: boundary modes first. Throws ComputeError if K_ii is not positive
/// definite, which only a folded element can cause.
CondensedElement condense(int order, const Eigen::MatrixXd& stiffness);

}  // namespace quadrille::galerkin
