#pragma once
// The value of a polynomial on a triangle from its Bernstein coefficients.

#include <array>
#include <vector>

#include "spectral/tri_bernstein.hpp"

namespace quadrille::spectral {

/// The value at the barycentric coordinates `lambda`, by de Casteljau's algorithm.
inline double bernstein_value(int order, const std::vector<double>& coefs, const std::array<double, 3>& lambda) {
  std::vector<double> c = coefs;
  for (int n = order; n > 0; --n)
    for (int k = 0, at = 0; k < n; ++k)
      for (int j = 0; j + k < n; ++j, ++at)
        c[at] = lambda[0] * c[bernstein_index(n, j, k)] + lambda[1] * c[bernstein_index(n, j + 1, k)] +
                lambda[2] * c[bernstein_index(n, j, k + 1)];
  return c[0];
}

}  // namespace quadrille::spectral
