#pragma once
// The orthonormal (Dubiner) basis of the reference triangle xi1, xi2 >= -1, xi1 + xi2 <= 0.
//
// Mode (p, q), p + q <= P, is c_pq P_p(eta1) ((1-eta2)/2)^p P_q^{(2p+1,0)}(eta2) in collapsed coordinates; modes are
// sorted by total degree d = p + q, then by p: modes of degree d are [d(d+1)/2, (d+1)(d+2)/2). They are evaluated by
// recurrences without a division by 1 - eta2, so the collapsed vertex and points outside the triangle are no special
// cases.

#include <Eigen/Dense>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::spectral {

constexpr int num_tri_modes(int order) { return (order + 1) * (order + 2) / 2; }

/// c_pq.
double orthogonal_scale(int p, int q);

/// The highest order of the tables behind all functions of this header; beyond it they throw Defect.
inline constexpr int max_tri_order = 48;

/// Values of all modes up to `order` at xi: writes num_tri_modes(order) numbers.
void orthogonal_values(int order, Vec2 xi, double* values);

/// Values and both derivatives at xi; each array has num_tri_modes(order) entries.
void orthogonal_gradients(int order, Vec2 xi, double* values, double* d_xi1, double* d_xi2);

/// The two polynomials with coefficients u and v at xi: the fastest way to one value of a vector field or map.
Vec2 orthogonal_sum(int order, const double* u, const double* v, Vec2 xi);

/// The same with the derivatives in `gradient`: rows u, v, columns xi1, xi2.
Vec2 orthogonal_sum(int order, const double* u, const double* v, Vec2 xi, Mat2& gradient);

/// Row i: the values of all modes at points[i].
Eigen::MatrixXd orthogonal_vandermonde(int order, const std::vector<Vec2>& points);

}  // namespace quadrille::spectral
