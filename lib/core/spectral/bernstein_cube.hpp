#pragma once
// Polynomials in three variables in Bernstein form on the unit cube.

#include <vector>

namespace quadrille::spectral {

/// A polynomial of degree `degree` in each variable: coefficient (i, j, k) at [(k * width + j) * width + i], width =
/// degree + 1, i along xi1.
struct BernsteinCube {
  int degree = 0;
  std::vector<double> coefs;
  double error = 0;  ///< bound of the difference of each coefficient from the exact one
};

/// A lower bound of the polynomial on the cube: its least coefficient less the error, sharpened by up to `depth`
/// bisections in all directions as long as it is not positive and no corner value proves that the polynomial is not
/// positive either.
double lower_bound(const BernsteinCube& polynomial, int depth);

}  // namespace quadrille::spectral
