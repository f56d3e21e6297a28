#pragma once
// The modes of the modified basis as products f_c(eta1) g_m(eta2) in collapsed coordinates, for sum factorisation
// (Karniadakis and Sherwin, sec. 4.1): an integral over the triangle is computed first along eta1, for each pair of the
// P + 2 factors f_c, then along eta2, for each pair of modes.
//
// With t = (1 - eta2) / 2, the factors and their modes are
//   f_0 = 1                       vertex 2
//   f_1 = (1 - eta1) / 2          vertex 0, edge 2
//   f_2 = (1 + eta1) / 2          vertex 1, edge 1
//   f_{3+i} = (1 - eta1^2) / 4 P_i^(1,1)(eta1)    edge 0 of degree i + 2, interior (i, 0), (i, 1), ...

#include <Eigen/Dense>
#include <vector>

#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

/// Factors at the points (eta1_i, eta2_j) of the collapsed Gauss rule, whose weights are eta1.weights[i] *
/// eta2.weights[j] / 2.
struct FactoredModes {
  Quadrature eta1, eta2;      ///< Gauss-Legendre, and Gauss-Jacobi for the weight 1 - eta2
  Eigen::MatrixXd f, df;      ///< points eta1 x factors: values and derivatives with respect to eta1
  Eigen::MatrixXd g, dg;      ///< points eta2 x modes, sorted by factor: values and derivatives with respect to eta2
  std::vector<int> first;     ///< the modes of factor c are columns first[c] to first[c + 1] - 1 of g
  std::vector<int> position;  ///< position in the modified basis of the mode of each column of g

  int num_factors() const { return static_cast<int>(f.cols()); }
  int num_modes(int factor) const { return first[factor + 1] - first[factor]; }
};

/// The modes of order P >= 1 at a rule of num_points >= 1 points per direction.
FactoredModes factored_modes(int order, int num_points);

/// Row m: the coefficients of mode m in the orthogonal basis of the same order. Computed once per order.
const Eigen::MatrixXd& modified_to_orthogonal(int order);

}  // namespace quadrille::spectral
