#include "spectral/modified_basis.hpp"

#include <cmath>
#include <vector>

#include "spectral/jacobi.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille {

namespace {

// q_0..q_n of (x, t).
void scaled_jacobi(int n, double x, double t, double* q) {
  q[0] = 1;
  for (int k = 0; k < n; ++k) {
    const JacobiStep step = jacobi_step(k, 1, 1);
    q[k + 1] = step.a * x * q[k] - (k > 0 ? step.c * t * t * q[k - 1] : 0);
  }
}

double edge_scale(int degree) { return 2.0 / (degree - 1) * std::sqrt((2 * degree - 1) / 2.0); }

void fill_edge(int order, double la, double lb, double* values) {
  if (order < 2) return;
  scaled_jacobi(order - 2, lb - la, la + lb, values);
  for (int d = 2; d <= order; ++d) values[d - 2] *= la * lb * edge_scale(d);
}

void fill_interior(int order, const double* l, double* values) {
  if (order < 3) return;
  std::vector<double> q(order - 2);
  scaled_jacobi(order - 3, l[1] - l[0], l[0] + l[1], q.data());
  const double bubble = l[0] * l[1] * l[2];
  int place = 0;
  for (int degree = 0; degree <= order - 3; ++degree) {
    for (int i = 0; i <= degree; ++i) {
      values[place++] = bubble * q[i] * jacobi(degree - i, 2 * i + 3, 1, 2 * l[2] - 1);
    }
  }
}

// The product of both bases has degree 2 P: a collapsed Gauss rule of P + 1 points in each direction is exact.
Eigen::MatrixXd make_to_orthogonal(int order) {
  const int n = num_tri_modes(order), m = order + 1;
  const Quadrature along = gauss_legendre(m), up = gauss_jacobi(m, 1, 0);
  Eigen::MatrixXd modified(n, m * m), orthogonal(n, m * m);
  for (int i = 0, column = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j, ++column) {
      const Vec2 xi{(1 + along.points[i]) * (1 - up.points[j]) / 2 - 1, up.points[j]};
      modified_values(order, xi, modified.col(column).data());
      orthogonal_values(order, xi, orthogonal.col(column).data());
      orthogonal.col(column) *= along.weights[i] * up.weights[j] / 2;
    }
  }
  return modified * orthogonal.transpose();
}

}  // namespace

void modified_values(int order, Vec2 xi, double* values) {
  const double l[3] = {-(xi.x + xi.y) / 2, (1 + xi.x) / 2, (1 + xi.y) / 2};
  for (int k = 0; k < 3; ++k) values[k] = l[k];
  for (int k = 0; k < 3; ++k) fill_edge(order, l[k], l[(k + 1) % 3], values + 3 + k * (order - 1));
  fill_interior(order, l, values + num_boundary_modes(order));
}

const Eigen::MatrixXd& modified_to_orthogonal(int order) {
  static PerOrder<Eigen::MatrixXd> tables(make_to_orthogonal);
  return tables[order];
}

void edge_mode_values(int order, double s, double* values) { fill_edge(order, (1 - s) / 2, (1 + s) / 2, values); }

}  // namespace quadrille
