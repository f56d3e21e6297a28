#pragma once
// The modified hierarchical C0 basis of the reference triangle (Karniadakis and Sherwin, sec. 3.2).
//
// With barycentric coordinates L0, L1, L2 and the scaled Jacobi polynomial q_n(x, t) = t^n P_n^(1,1)(x / t):
//   vertex k:                     L_k
//   edge 0, degree d = 2..P:      L0 L1 q_{d-2}(L1 - L0, L0 + L1) c_d,   c_d = 2 / (d - 1) * sqrt((2 d - 1) / 2)
//   edge 1:                       L1 L2 q_{d-2}(2 L2 - 1, 1) c_d
//   edge 2:                       L2 L0 q_{d-2}(1 - 2 L2, 1) c_d
//   interior (i, j), i + j <= P - 3:  L0 L1 L2 q_i(L1 - L0, L0 + L1) P_j^(2i+3,1)(2 L2 - 1)
// An edge mode is zero on the other edges. On its edge, with s in [-1, 1] from vertex k to k + 1, it has the derivative
// -P_{d-1}(s) scaled to norm 1: the same on all edges, times (-1)^d when walked backwards. Each mode is a function of
// eta1 times one of eta2 in collapsed coordinates (see FactoredModes).
//
// Ranking for order P: 3 vertices; edge 0, d = 2..P; edge 1; edge 2; interior sorted by i + j, then i.

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "base/vec2.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

constexpr int num_boundary_modes(int order) { return 3 * order; }
constexpr int num_interior_modes(int order) { return (order - 1) * (order - 2) / 2; }
/// Position of the mode of degree d on edge k, 2 <= d <= order.
constexpr int edge_mode(int order, int edge, int degree) { return 3 + edge * (order - 1) + degree - 2; }

/// Position of interior mode (i, j).
constexpr int interior_mode(int order, int i, int j) {
  return num_boundary_modes(order) + (i + j) * (i + j + 1) / 2 + i;
}
/// c_d.
inline double edge_mode_scale(int degree) { return 2.0 / (degree - 1) * std::sqrt((2 * degree - 1) / 2.0); }

/// Values and both derivatives of all modes of order P >= 1 at xi; each array has (P+1)(P+2)/2 entries.
void modified_gradients(int order, Vec2 xi, double* values, double* d_xi1, double* d_xi2);

/// Positions of the modes of `order` among those of `higher_order` (the basis is hierarchical). Tables are therefore
/// computed for a few orders only and restricted to the others.
const std::vector<int>& modified_subset(int order, int higher_order);

/// The order of the table that serves `order`: 8, 12, 16, 20, ...
constexpr int table_order(int order) { return order <= 8 ? 8 : (order + 3) / 4 * 4; }

/// The trace of an edge mode of degree 2..P at s in [-1, 1] along its edge: writes P - 1 numbers.
void edge_mode_values(int order, double s, double* values);

// The modes of the modified basis as products f_c(eta1) g_m(eta2) in collapsed coordinates, for sum factorisation
// (Karniadakis and Sherwin, sec. 4.1): an integral over the triangle is computed first along eta1, for each pair of the
// P + 2 factors f_c, then along eta2, for each pair of modes.
//
// With t = (1 - eta2) / 2, the factors and their modes are
//   f_0 = 1                       vertex 2
//   f_1 = (1 - eta1) / 2          vertex 0, edge 2
//   f_2 = (1 + eta1) / 2          vertex 1, edge 1
//   f_{3+i} = (1 - eta1^2) / 4 P_i^(1,1)(eta1)    edge 0 of degree i + 2, interior (i, 0), (i, 1), ...

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
