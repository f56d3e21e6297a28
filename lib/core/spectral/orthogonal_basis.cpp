#include "spectral/orthogonal_basis.hpp"

#include <array>
#include <cmath>
#include <type_traits>

#include "base/error.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

double orthogonal_scale(int p, int q) { return std::sqrt((2 * p + 1) * (p + q + 1) / 2.0); }

namespace {

constexpr int max_modes = num_tri_modes(max_tri_order);

// phi(d, p) has degree d = p + q and position d (d + 1) / 2 + p. Its recurrence in q keeps p, so the modes of one
// degree follow from the two degrees before it, entry by entry: loops over p that a compiler vectorises.
//   q > 0:  phi(d, p) = (a xi2 + b) phi(d-1, p) - c phi(d-2, p)
//   q = 0:  phi(d, d) = a s phi(d-1, d-1) - c h^2 phi(d-2, d-2),  s = xi1 + (1 + xi2) / 2,  h = (1 - xi2) / 2
struct Recurrence {
  std::array<double, max_modes> a{}, b{}, c{};
};

Recurrence make_recurrence() {
  Recurrence r;
  for (int d = 1; d <= max_tri_order; ++d) {
    const int row = d * (d + 1) / 2;
    for (int p = 0; p < d; ++p) {
      const int q = d - p - 1;
      const JacobiStep step = jacobi_step(q, 2 * p + 1, 0);
      const double ratio = orthogonal_scale(p, q + 1) / orthogonal_scale(p, q);
      r.a[row + p] = step.a * ratio;
      r.b[row + p] = step.b * ratio;
      r.c[row + p] = q == 0 ? 0 : step.c * orthogonal_scale(p, q + 1) / orthogonal_scale(p, q - 1);
    }
    const JacobiStep step = jacobi_step(d - 1, 0, 0);
    r.a[row + d] = step.a * orthogonal_scale(d, 0) / orthogonal_scale(d - 1, 0);
    r.c[row + d] = d == 1 ? 0 : step.c * orthogonal_scale(d, 0) / orthogonal_scale(d - 2, 0);
  }
  return r;
}

const Recurrence& recurrence() {
  static const Recurrence table = make_recurrence();
  return table;
}

void require_order(int order) {
  if (order < 0 || order > max_tri_order) throw Defect("no table for this order of the orthogonal basis");
}

// `Order`: int, or a constant with which the compiler unrolls the short loops of low orders, which most elements have.
template <class Order>
void fill_rows(Order order, Vec2 xi, double* __restrict f) {
  const Recurrence& r = recurrence();
  const double y = xi.y, s = xi.x + (1 + xi.y) / 2, h = (1 - xi.y) / 2, h2 = h * h;
  f[0] = orthogonal_scale(0, 0);
  if (order == 0) return;
  f[1] = (r.a[1] * y + r.b[1]) * f[0];
  f[2] = r.a[2] * s * f[0];
  for (int d = 2; d <= order; ++d) {
    const int row = d * (d + 1) / 2, one = row - d, two = one - d + 1;
    for (int p = 0; p < d - 1; ++p) {
      f[row + p] = (r.a[row + p] * y + r.b[row + p]) * f[one + p] - r.c[row + p] * f[two + p];
    }
    f[row + d - 1] = (r.a[row + d - 1] * y + r.b[row + d - 1]) * f[one + d - 1];
    f[row + d] = r.a[row + d] * s * f[one + d - 1] - r.c[row + d] * h2 * f[two + d - 2];
  }
}

template <int order = 2>
void fill_unrolled(int requested, Vec2 xi, double* f) {
  if (requested == order) return fill_rows(std::integral_constant<int, order>{}, xi, f);
  if constexpr (order < 12) fill_unrolled<order + 1>(requested, xi, f);
}

void fill_values(int order, Vec2 xi, double* f) {
  2 <= order&& order <= 12 ? fill_unrolled(order, xi, f) : fill_rows(order, xi, f);
}

void fill_gradients(int order, Vec2 xi, const double* __restrict f, double* __restrict f1, double* __restrict f2) {
  const Recurrence& r = recurrence();
  const double y = xi.y, s = xi.x + (1 + xi.y) / 2, h = (1 - xi.y) / 2, h2 = h * h;
  f1[0] = f2[0] = 0;
  if (order == 0) return;
  f1[1] = 0;
  f2[1] = r.a[1] * f[0];
  f1[2] = r.a[2] * f[0];
  f2[2] = r.a[2] * f[0] / 2;
  for (int d = 2; d <= order; ++d) {
    const int row = d * (d + 1) / 2, one = row - d, two = one - d + 1;
    for (int p = 0; p < d - 1; ++p) {
      const double slope = r.a[row + p] * y + r.b[row + p];
      f1[row + p] = slope * f1[one + p] - r.c[row + p] * f1[two + p];
      f2[row + p] = slope * f2[one + p] + r.a[row + p] * f[one + p] - r.c[row + p] * f2[two + p];
    }
    const int last = row + d - 1;
    f1[last] = (r.a[last] * y + r.b[last]) * f1[one + d - 1];
    f2[last] = (r.a[last] * y + r.b[last]) * f2[one + d - 1] + r.a[last] * f[one + d - 1];
    const int top = row + d, below = one + d - 1, below2 = two + d - 2;
    f1[top] = r.a[top] * (s * f1[below] + f[below]) - r.c[top] * h2 * f1[below2];
    f2[top] = r.a[top] * (s * f2[below] + f[below] / 2) - r.c[top] * (h2 * f2[below2] - h * f[below2]);
  }
}

double sum(const double* a, const double* b, int n) {
  return Eigen::Map<const Eigen::VectorXd>(a, n).dot(Eigen::Map<const Eigen::VectorXd>(b, n));
}

}  // namespace

void orthogonal_values(int order, Vec2 xi, double* values) {
  require_order(order);
  fill_values(order, xi, values);
}

void orthogonal_gradients(int order, Vec2 xi, double* values, double* d_xi1, double* d_xi2) {
  require_order(order);
  fill_values(order, xi, values);
  fill_gradients(order, xi, values, d_xi1, d_xi2);
}

Vec2 orthogonal_sum(int order, const double* u, const double* v, Vec2 xi) {
  double f[max_modes];
  orthogonal_values(order, xi, f);
  const int n = num_tri_modes(order);
  return {sum(u, f, n), sum(v, f, n)};
}

Vec2 orthogonal_sum(int order, const double* u, const double* v, Vec2 xi, Mat2& gradient) {
  double f[max_modes], f1[max_modes], f2[max_modes];
  orthogonal_gradients(order, xi, f, f1, f2);
  const int n = num_tri_modes(order);
  gradient = {sum(u, f1, n), sum(u, f2, n), sum(v, f1, n), sum(v, f2, n)};
  return {sum(u, f, n), sum(v, f, n)};
}

Eigen::MatrixXd orthogonal_vandermonde(int order, const std::vector<Vec2>& points) {
  const int rows = static_cast<int>(points.size()), cols = num_tri_modes(order);
  Eigen::MatrixXd matrix(rows, cols);
  std::vector<double> values(cols);
  for (int i = 0; i < rows; ++i) {
    orthogonal_values(order, points[i], values.data());
    for (int n = 0; n < cols; ++n) matrix(i, n) = values[n];
  }
  return matrix;
}

}  // namespace quadrille::spectral
