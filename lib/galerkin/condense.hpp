#pragma once
// Static condensation: eliminates the interior modes of an element (Karniadakis and Sherwin, sec. 4.1.6).

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

#include "spectral/modified_basis.hpp"

namespace quadrille::galerkin {

/// The interior modes i of an element, which its boundary modes b determine; K_ii = L L^T.
struct InteriorModes {
  Eigen::MatrixXd factor;    ///< L, in the lower triangle
  Eigen::MatrixXd coupling;  ///< K_ib

  /// -K_ii^-1 K_ib b: the interior coefficients of least energy for boundary coefficients b, one function a column.
  Eigen::MatrixXd of(const Eigen::MatrixXd& boundary) const;
};

/// An element matrix after elimination of the interior modes.
struct CondensedElement {
  Eigen::MatrixXd schur;  ///< K_bb - K_bi K_ii^-1 K_ib, over the boundary modes
  std::optional<InteriorModes> interior;
};

/// Eliminates the interior modes. Throws ComputeError(`failure`) if K_ii is not positive definite.
CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure);

/// The matrices of all elements; those of the same shape and order share one object (mesh/element_shapes.hpp).
using CondensedElements = std::vector<std::shared_ptr<const CondensedElement>>;

/// `stiffness` is ordered as the modified basis: boundary modes first. Throws ComputeError if K_ii is not positive
/// definite, which only a folded element can cause.
CondensedElement condense(int order, const Eigen::MatrixXd& stiffness);

/// condense(order, stiffness).interior alone, at a third of the cost.
InteriorModes interior_modes(int order, const Eigen::MatrixXd& stiffness);

/// The numbers that the interior modes of an element of this order consist of.
constexpr std::size_t size_of_interior(int order) {
  const std::size_t ni = spectral::num_interior_modes(order), nb = spectral::num_boundary_modes(order);
  return ni * (ni + nb);
}

}  // namespace quadrille::galerkin
