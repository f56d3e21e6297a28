#pragma once
// From the values at Gauss-Lobatto-Legendre nodes to Bernstein coefficients, in one variable. Private to this folder.

#include <vector>

namespace quadrille::spectral {

inline constexpr double unit_roundoff = 0x1p-53;
inline constexpr double extended_roundoff = 0x1p-64;

using Rows = std::vector<long double>;  ///< a matrix, row by row

/// C(n, k) for k from 0 to n.
std::vector<double> binomials(int n);

/// Tables that depend on the order only.
struct BernsteinTables {
  Rows value, derivative;  ///< nodes -> Bernstein coefficients of the polynomial and of its derivative by xi in [-1, 1]
  double value_norm, derivative_norm;                        ///< greatest row sums of absolute values
  std::vector<double> binomial_n, binomial_d, binomial_det;  ///< of the degrees n, n - 1, 2 n - 1

  explicit BernsteinTables(int n);
};

/// order >= 1.
const BernsteinTables& bernstein_tables(int order);

/// Halves a polynomial in one variable by de Casteljau's averages. `low` has its coefficients, at steps of `stride`,
/// and `high` a copy of them; they become those of the two halves.
void halve_line(double* low, double* high, int width, int stride);

}  // namespace quadrille::spectral
