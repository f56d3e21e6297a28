#pragma once
// The resolution ratio R of a quad mesh: how much a solution that is equally smooth in all directions loses to elements
// of unequal sizes, without solving for it.
//
// The squared L2 error of polynomials of degree p in an element is proportional to the integral of
// |x_xi1|^2q + |x_xi2|^2q over it, q = p + 1 (skewness of a parallelogram costs nothing). With lengths in units of the
// prescribed length h of each element,
//
//   E = sum over elements of  int (|x_xi1 / h|^2q + |x_xi2 / h|^2q) dA / h^2,   R = E / (2 A (A / n)^q),
//
// xi in [0, 1]^2, A = int dA / h^2, n elements: the denominator is E of n equal squares. So R >= 1, and the error is
// about sqrt(R) times theirs. q = 4.

#include <array>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

constexpr int resolution_power = 4;  ///< q

struct Resolution {
  double ratio = 1;  ///< R of the elements that count; 1 if none does
  /// By element: the parts of E that its lengths along xi1 and xi2 have, of all 1. 0 where it does not count.
  std::vector<std::array<double, 2>> parts;
};

/// Without prescribed lengths (elem_prescribed_length), h is the same for all elements; those with the length 0 do not
/// count. O(N^3) for each element of order N.
Resolution resolution(const QuadMesh& mesh);

/// By element: the square root of its area over the prescribed length; 1 where wall layers prescribe it. Prescribed
/// lengths must be stored.
std::vector<double> relative_sizes(const QuadMesh& mesh);

}  // namespace quadrille::mesh
