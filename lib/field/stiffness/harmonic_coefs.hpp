#pragma once
// The solution inside an element whose energy was computed by harmonic polynomials.

#include <Eigen/Dense>

#include "spectral/tri_map.hpp"

namespace quadrille::stiffness {

/// Coefficients in the orthogonal basis of order P, one function a column: the projection of the harmonic polynomial
/// `projection` * `boundary` (harmonic_element.hpp) onto the polynomials of the reference triangle, plus the function
/// of least energy on an equilateral triangle that corrects its boundary modes to the given ones.
Eigen::MatrixXd harmonic_coefs(const spectral::TriMap& map, int order, const Eigen::MatrixXd& projection,
                               const Eigen::MatrixXd& boundary);

}  // namespace quadrille::stiffness
