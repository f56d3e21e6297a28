#pragma once
// Elements of the screened Poisson equation -Δv + mu v = f, with mu >= 0 and f given at the points of a rule of
// quadrature: their matrices, condensed, and their loads (lib/method.md §4).

#include <Eigen/Dense>
#include <vector>

#include "base/vec2.hpp"
#include "spectral/tri_map.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {

/// Where mu and f are needed: the points of a collapsed Gauss rule, exact for smooth mu and the modes of this order.
std::vector<Vec2> rule_points(const spectral::TriMap& map, int order);

struct ScreenedElement {
  CondensedElement element;
  Eigen::VectorXd weights;              ///< of the points, with det J
  Eigen::LLT<Eigen::MatrixXd> factors;  ///< of the matrix of the interior modes; of order >= 3
};

/// `rate`: mu at the points. Throws ComputeError if the element is folded.
ScreenedElement screened_element(const spectral::TriMap& map, int order, const Eigen::VectorXd& rate);

/// The right-hand side of an element, one function a column.
struct ElementLoad {
  Eigen::MatrixXd boundary;  ///< for the boundary modes, without the interior ones
  Eigen::MatrixXd interior;  ///< coefficients of the interior modes where the boundary modes are 0
};
/// `values`: of f at the points.
ElementLoad element_load(int order, const ScreenedElement& element, const Eigen::MatrixXd& values);

/// The coefficients of all modes of the modified basis from those of the boundary modes.
Eigen::MatrixXd all_modes(const ScreenedElement& element, const ElementLoad& load, const Eigen::MatrixXd& boundary);
/// The values at the points of functions with these modes.
Eigen::MatrixXd values_at_points(int order, const Eigen::MatrixXd& modes);

}  // namespace quadrille::stiffness
