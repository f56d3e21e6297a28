#pragma once
// Interpolation in one variable through given points (barycentric form, Berrut and Trefethen 2004).

#include <Eigen/Dense>
#include <vector>

namespace quadrille::spectral {

/// Row i: the values of the Lagrange polynomials of `from` at to[i]. Rows sum to 1.
Eigen::MatrixXd interpolation_matrix(const std::vector<double>& from, const std::vector<double>& to);

/// Row i: the derivatives of the Lagrange polynomials of `points` at points[i].
Eigen::MatrixXd differentiation_matrix(const std::vector<double>& points);

}  // namespace quadrille::spectral
