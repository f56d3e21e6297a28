#pragma once
// The matrices of an element over its boundary modes: by static condensation, which eliminates the interior modes
// (Karniadakis and Sherwin, sec. 4.1.6), and for continuous elements by the cheapest way that is accurate.

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

#include "spectral/modified_basis.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::stiffness {

/// A symmetric matrix: the lower triangle, column by column.
class SymmetricMatrix {
 public:
  SymmetricMatrix() = default;
  /// From the lower triangle of a square matrix; its upper triangle is not read.
  explicit SymmetricMatrix(const Eigen::MatrixXd& lower);

  Eigen::Index rows() const { return rows_; }
  /// All entries.
  Eigen::MatrixXd dense() const;

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

/// From this order on, elements use harmonic polynomials. At lower orders the interior modes are few, and the zeros of
/// the field are up to ten times more accurate with them (stadium, order 8: 4e-8 and 6e-7).
constexpr int least_harmonic_order = 11;

/// By harmonic polynomials (harmonic_element.hpp) or, where these are unsuitable, by elimination of the interior modes.
/// Throws ComputeError if the element is folded.
CondensedElement condensed_element(const spectral::TriMap& map, int order);

/// The coefficients in the orthogonal basis that belong to coefficients of the boundary modes, one function a column.
/// Functions of neighbours that agree in the boundary modes of their edge agree on it. `element.has_interior()`.
Eigen::MatrixXd element_coefs(const spectral::TriMap& map, int order, const CondensedElement& element,
                              const Eigen::MatrixXd& boundary);

/// The numbers that has_interior() keeps.
std::size_t size_of_interior(const CondensedElement& element);

/// For each element, the first one of the same shape: a similarity transform maps it onto the other, vertex by vertex,
/// within about 1e-12 of the element's size. Mirror images count as different. The stiffness matrices of the Laplace
/// operator in the plane do not change with the place, the direction and the size of an element: similar elements share
/// them. The rings of a fan are similar to each other, and so are the fans of equal corners, with which most of a mesh
/// is made.
std::vector<int> first_of_shape(const std::vector<spectral::TriMap>& maps);

}  // namespace quadrille::stiffness
