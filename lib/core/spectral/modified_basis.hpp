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
// eta1 times one of eta2 in collapsed coordinates (factored_modes.hpp).
//
// Ranking for order P: 3 vertices; edge 0, d = 2..P; edge 1; edge 2; interior sorted by i + j, then i.

#include <cmath>
#include <vector>

#include "base/vec2.hpp"

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

}  // namespace quadrille::spectral
