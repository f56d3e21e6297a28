#pragma once
// The element map of a hexahedron of order N on [-1,1]^3, and proofs of its validity. Nodes at tensor
// Gauss-Lobatto-Legendre points, xi1 fastest, then xi2, then xi3 (model/hex_mesh.hpp).
//
// The map X is first multiplied by A, the inverse of its Jacobian at xi = 0, so that A X = xi + Z with a small Z and
// all that follows does not depend on size, thinness or skewness of the element. det J = det(I + Z') / det A. Two
// bounds of det(I + Z'), the cheap one first:
//   - rho, the least of the row and column norms of Z' from its Bernstein coefficients: if rho < 1, each eigenvalue of
//     I + Z' has at least the modulus 1 - rho, and det(I + Z') >= (1 - rho)^3, positive as it is along I + t Z';
//   - the Bernstein coefficients of det(I + Z'), of degree 3N - 1 in each variable, less their rounding errors, halved
//     in all directions where that does not suffice.

#include <array>

#include "base/vec3.hpp"

namespace quadrille::spectral {

/// What is proved of an element.
struct HexBounds {
  double jacobian = 0;                ///< a lower bound of det J, not above 0 if none is proved
  std::array<double, 3> derivatives;  ///< upper bounds of |X_xi1|, |X_xi2|, |X_xi3|
};

/// Rounding errors grow with the condition of the Bernstein basis in three variables: beyond order 12 they exceed det
/// J.
HexBounds hex_bounds(int order, const Vec3* nodes, int depth = 4);

/// A lower bound of det J if each node may be `node_distance` away from that of the element with these bounds.
double moved_jacobian_bound(int order, const HexBounds& bounds, double node_distance);

/// Least sampled scaled Jacobian det J / (|X_xi1| |X_xi2| |X_xi3|) on (N+3)^3 equispaced points, ends included; -1
/// where det J <= 0.
double hex_scaled_jacobian(int order, const Vec3* nodes);

}  // namespace quadrille::spectral
