#include "spectral/bernstein_tables.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

/// Column `node` of M: the Lagrange polynomial as a product of linear factors (1 - z_k) X - z_k (1 - X), X in [0, 1].
void lagrange_column(const std::vector<double>& points, int node, const std::vector<double>& binomial, Rows& m) {
  const int n = static_cast<int>(points.size()) - 1;
  Rows product(n + 1, 0.0L);
  product[0] = 1;
  int degree = 0;
  for (int k = 0; k <= n; ++k) {
    if (k == node) continue;
    const long double gap = static_cast<long double>(points[node]) - points[k];
    const long double low = -(1.0L + points[k]) / gap, high = (1.0L - points[k]) / gap;
    for (int i = ++degree; i > 0; --i) product[i] = product[i] * low + product[i - 1] * high;
    product[0] *= low;
  }
  for (int i = 0; i <= n; ++i) m[i * (n + 1) + node] = product[i] / binomial[i];
}

double row_norm(const Rows& matrix, int columns) {
  double norm = 0;
  for (std::size_t r = 0; r < matrix.size(); r += columns) {
    long double sum = 0;
    for (int c = 0; c < columns; ++c) sum += std::abs(matrix[r + c]);
    norm = std::max(norm, static_cast<double>(sum));
  }
  return norm;
}

}  // namespace

std::vector<double> binomials(int n) {
  std::vector<double> row(n + 1, 1.0);
  for (int k = 1; k < n; ++k) row[k] = std::round(row[k - 1] * (n - k + 1) / k);
  return row;
}

BernsteinTables::BernsteinTables(int n) : value((n + 1) * (n + 1)), derivative(n * (n + 1)) {
  binomial_n = binomials(n);
  binomial_d = binomials(n - 1);
  binomial_det = binomials(2 * n - 1);
  for (int k = 0; k <= n; ++k) lagrange_column(gll_points(n), k, binomial_n, value);
  for (int i = 0; i < n * (n + 1); ++i) derivative[i] = (value[i + n + 1] - value[i]) * n / 2;
  value_norm = row_norm(value, n + 1);
  derivative_norm = row_norm(derivative, n + 1);
}

const BernsteinTables& bernstein_tables(int order) {
  if (order < 1) throw Defect("an element of order " + std::to_string(order));
  return table_per_order<BernsteinTables>(order);
}

void halve_line(double* low, double* high, int width, int stride) {
  for (int step = 1; step < width; ++step) {
    for (int i = 0; i < width - step; ++i) high[i * stride] = (high[i * stride] + high[(i + 1) * stride]) / 2;
    low[step * stride] = high[0];
  }
}

}  // namespace quadrille::spectral
