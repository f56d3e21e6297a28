#pragma once
// The stiffness matrix K_mn = int grad psi_m . grad psi_n of an element, psi the modified basis, and static
// condensation, which eliminates the interior modes (Karniadakis and Sherwin, sec. 4.1.6).

#include <Eigen/Dense>
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "spectral/modified_basis.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::stiffness {

/// Affine elements combine three reference matrices, computed once per order. Curved elements are integrated by a
/// collapsed Gauss rule with order + `extra_points` points in each direction, because the integrand is rational. Sums
/// are factored (Karniadakis and Sherwin, sec. 4.1): about order^5 operations per element instead of order^6.
Eigen::MatrixXd stiffness_matrix(const spectral::TriMap& map, int order, int extra_points = 6);

/// The matrix of a lower order, extracted from the matrix of `higher_order`: the basis is hierarchical.
Eigen::MatrixXd cut_down(const Eigen::MatrixXd& stiffness, int higher_order, int order);

/// The lower triangle, column by column.
class SymmetricMatrix {
 public:
  SymmetricMatrix() = default;
  /// From the lower triangle of a square matrix; its upper triangle is not read.
  explicit SymmetricMatrix(const Eigen::MatrixXd& lower);

  Eigen::Index rows() const { return rows_; }
  double operator()(Eigen::Index i, Eigen::Index j) const {
    const Eigen::Index row = std::max(i, j), column = std::min(i, j);
    return columns_[column * (2 * rows_ - column - 1) / 2 + row];
  }
  /// All entries.
  Eigen::MatrixXd dense() const;
  Eigen::MatrixXd operator*(const Eigen::MatrixXd& x) const;

 private:
  Eigen::Index rows_ = 0;
  Eigen::VectorXd columns_;
};

/// An element matrix over its boundary modes b alone, and what determines the solution inside: one of two, or neither
/// if it is not kept.
struct CondensedElement {
  SymmetricMatrix schur;  ///< K_bb - K_bi K_ii^-1 K_ib, or its substitute of harmonic_element.hpp
  /// If interior modes i were eliminated, -K_ii^-1 K_ib: their coefficients of least energy by boundary mode.
  std::optional<Eigen::MatrixXd> interior;
  Eigen::MatrixXd projection;  ///< onto harmonic polynomials, else empty (harmonic_element.hpp)

  bool has_interior() const { return interior || projection.size() > 0; }
};

/// Eliminates the interior modes. Throws ComputeError(`failure`) if K_ii is not positive definite.
CondensedElement eliminate_interior(const Eigen::MatrixXd& k_ii, const Eigen::MatrixXd& k_ib,
                                    const Eigen::MatrixXd& k_bb, const char* failure);

/// The matrices of all elements; those of the same shape and order share one object (first_of_shape).
using CondensedElements = std::vector<std::shared_ptr<const CondensedElement>>;

/// `stiffness` is ordered as the modified basis: boundary modes first. Throws ComputeError if K_ii is not positive
/// definite, which only a folded element can cause.
CondensedElement condense(int order, const Eigen::MatrixXd& stiffness);

}  // namespace quadrille::stiffness
