#pragma once
// The modified hierarchical C0 basis of the reference triangle (Karniadakis and Sherwin, sec. 3.2).
//
// With barycentric coordinates L0, L1, L2 and the scaled Jacobi polynomial q_n(x, t) = t^n P_n^(1,1)(x / t):
//   vertex k:                     L_k
//   edge k, degree d = 2..P:      L_a L_b q_{d-2}(L_b - L_a, L_a + L_b) * 2 / (d - 1) * sqrt((2 d - 1) / 2),
//                                 a = k, b = k + 1 (mod 3): zero on the other edges, times (-1)^d when walked backwards
//   interior (i, j), i + j <= P - 3:  L0 L1 L2 q_i(L1 - L0, L0 + L1) P_j^(2i+3,1)(2 L2 - 1)
// On its edge, with s in [-1, 1] along it, an edge mode has the derivative -P_{d-1}(s) scaled to norm 1.
// (Edge 0 and the interior have the book's modes; edges 1 and 2 have those of edge 0 rotated, so that all edges are
// alike.)
//
// Ranking for order P: 3 vertices; edge 0, d = 2..P; edge 1; edge 2; interior sorted by i + j, then i.

#include <Eigen/Dense>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::spectral {

constexpr int num_boundary_modes(int order) { return 3 * order; }
constexpr int num_interior_modes(int order) { return (order - 1) * (order - 2) / 2; }
/// Position of the mode of degree d on edge k, 2 <= d <= order.
constexpr int edge_mode(int order, int edge, int degree) { return 3 + edge * (order - 1) + degree - 2; }

/// Values of all modes of order P >= 1 at xi: writes (P+1)(P+2)/2 numbers.
void modified_values(int order, Vec2 xi, double* values);

/// Values and both derivatives at xi; each array has (P+1)(P+2)/2 entries.
void modified_gradients(int order, Vec2 xi, double* values, double* d_xi1, double* d_xi2);

/// Positions of the modes of `order` among those of `higher_order` (the basis is hierarchical). Tables are therefore
/// computed for a few orders only and restricted to the others.
const std::vector<int>& modified_subset(int order, int higher_order);

/// The order of the table that serves `order`: 8, 12, 16, 20, ...
constexpr int table_order(int order) { return order <= 8 ? 8 : (order + 3) / 4 * 4; }

/// Row m: the coefficients of mode m in the orthogonal basis of the same order. Computed once per order.
const Eigen::MatrixXd& modified_to_orthogonal(int order);

/// The trace of an edge mode of degree 2..P at s in [-1, 1] along its edge: writes P - 1 numbers.
void edge_mode_values(int order, double s, double* values);

}  // namespace quadrille::spectral
