#pragma once
// Bernstein form of polynomials on a triangle: the convex hull of the coefficients bounds the polynomial.
//
// Coefficient (i, j, k), i + j + k = n, belongs to barycentric coordinates (of vertex 0, 1, 2); ranking: k slowest,
// then j: index = offset(k) + j with offset(k) = k (2n + 3 - k) / 2. (i = n - j - k.)

#include <array>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::spectral {

constexpr int num_bernstein(int order) { return (order + 1) * (order + 2) / 2; }
constexpr int bernstein_index(int order, int j, int k) { return k * (2 * order + 3 - k) / 2 + j; }

/// Coefficients of degree `order` from coefficients in the orthogonal basis (same degree). The modes of each degree are
/// added in their own Bernstein form, which is exact to round-off up to order 30, and the sum is elevated degree by
/// degree.
std::vector<double> bernstein_from_orthogonal(int order, const std::vector<double>& coefs);
std::vector<double> bernstein_from_orthogonal(int order, const double* coefs);

/// The four children of a triangle at its edge midpoints: child c < 3 keeps vertex c, child 3 is the middle one, with
/// vertices (mid edge 1, mid edge 2, mid edge 0): all have the parent's orientation. By de Casteljau's algorithm.
std::array<std::vector<double>, 4> bernstein_subdivide(int order, const std::vector<double>& coefs);

/// The two halves of a triangle that is cut from the middle of local edge `edge` (vertex edge to edge + 1) to the
/// opposite vertex: in `first` the middle replaces vertex edge + 1, in `second` vertex `edge`. Each array has
/// num_bernstein(order) entries; `first` or `second` may be `coefs` itself.
void bernstein_bisect(int order, const double* coefs, int edge, double* first, double* second);

/// Coefficients (degree order - 1) of the derivatives along (vertex 1 - vertex 0) and (vertex 2 - vertex 0).
std::array<std::vector<double>, 2> bernstein_derivatives(int order, const std::vector<double>& coefs);

/// Product of two polynomials: degree a + b.
std::vector<double> bernstein_product(int order_a, const std::vector<double>& a, int order_b,
                                      const std::vector<double>& b);

/// The same polynomial in the form of degree order + 1.
std::vector<double> bernstein_elevate(int order, const std::vector<double>& coefs);

/// A proved lower bound of det(d x / d xi) over the triangle whose x and y have these coefficients (degree `order`):
/// the least Bernstein coefficient less a bound of the rounding errors, subdivided up to `depth` times while it is not
/// positive and no vertex value proves that it cannot be.
double jacobian_lower_bound(int order, const std::vector<double>& x, const std::vector<double>& y, int depth = 3);

}  // namespace quadrille::spectral
