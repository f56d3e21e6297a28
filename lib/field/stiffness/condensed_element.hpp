#pragma once
// The matrices of an element for continuous elements, by the cheapest way that is accurate.

#include <Eigen/Dense>
#include <vector>

#include "spectral/tri_map.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {

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
