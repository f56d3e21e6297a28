#pragma once
// Static condensation: eliminates the interior modes of an element (Karniadakis and Sherwin, sec. 4.1.6).

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

#include "spectral/modified_basis.hpp"

namespace quadrille::stiffness {

/// The interior modes i of an element, which its boundary modes b determine; K_ii = L L^T.
struct InteriorModes {
  Eigen::MatrixXd factor;    ///< L, in the lower triangle
  Eigen::MatrixXd coupling;  ///< K_ib

  /// -K_ii^-1 K_ib b: the interior coefficients of least energy for boundary coefficients b, one function a column.
  Eigen::MatrixXd of(const Eigen::MatrixXd& boundary) const;
};

/// An element matrix over the boundary modes alone, and what determines the solution inside: one of two, or neither if
/// it is not kept.
struct CondensedElement {
  Eigen::MatrixXd schur;                  ///< K_bb - K_bi K_ii^-1 K_ib, or its substitute of harmonic_element.hpp
  std::optional<InteriorModes> interior;  ///< if interior modes were eliminated
  Eigen::MatrixXd projection;             ///< onto harmonic polynomials, else empty (harmonic_element.hpp)

  bool has_interior() const { return interior || projection.size() > 0; }
};

/// Eliminates the interior modes. Throws ComputeError(`failure`) if K_ii is not positive definite.
CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure);

/// The matrices of all elements; those of the same shape and order share one object (mesh/element_shapes.hpp).
using CondensedElements = std::vector<std::shared_ptr<const CondensedElement>>;

/// `stiffness` is ordered as the modified basis: boundary modes first. Throws ComputeError if K_ii is not positive
/// definite, which only a folded element can cause.
CondensedElement condense(int order, const Eigen::MatrixXd& stiffness);

}  // namespace quadrille::stiffness
