#include "galerkin/trace_element.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::galerkin {

namespace {

// The modified basis along the three edges, at Gauss points.
struct EdgeTable {
  spectral::Quadrature rule;
  std::array<Eigen::MatrixXd, 3> values, d1, d2;  // modes x points
};

EdgeTable make_edge_table(int order, int num_points) {
  EdgeTable table;
  table.rule = spectral::gauss_legendre(num_points);
  const int n = spectral::num_tri_modes(order);
  for (int k = 0; k < 3; ++k) {
    for (auto* matrix : {&table.values[k], &table.d1[k], &table.d2[k]}) matrix->resize(n, num_points);
    for (int q = 0; q < num_points; ++q) {
      const Vec2 xi = spectral::tri_edge_point(k, (1 + table.rule.points[q]) / 2);
      spectral::modified_gradients(order, xi, table.values[k].col(q).data(), table.d1[k].col(q).data(),
                                   table.d2[k].col(q).data());
    }
  }
  return table;
}

const EdgeTable& edge_table(int order, int num_points) {
  static std::mutex mutex;
  static std::map<std::pair<int, int>, std::unique_ptr<EdgeTable>> tables;
  const std::lock_guard lock(mutex);
  auto& entry = tables[{order, num_points}];
  if (!entry) entry = std::make_unique<EdgeTable>(make_edge_table(order, num_points));
  return *entry;
}

// The terms of the form along one edge. Columns are Gauss points; the quadrature weights are kept separately.
struct EdgeTerms {
  Eigen::MatrixXd flux;              ///< d_n phi ds, without weight
  Eigen::MatrixXd values;            ///< phi
  Eigen::MatrixXd trace;             ///< trace modes
  Eigen::VectorXd weights, lengths;  ///< of the rule; |dx/ds| at its points
};

EdgeTerms edge_terms(const spectral::TriMap& map, int order, int edge, int edge_order, int num_points) {
  const EdgeTable& table = edge_table(order, num_points);
  const Vec2 along = (spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0)) / 2;  // d xi / d s
  EdgeTerms terms;
  terms.values = table.values[edge];
  terms.flux.resize(terms.values.rows(), num_points);
  terms.trace.resize(num_trace_modes(edge_order), num_points);
  terms.weights.resize(num_points);
  terms.lengths.resize(num_points);
  for (int q = 0; q < num_points; ++q) {
    const double s = table.rule.points[q];
    Vec2 x;
    Mat2 j;
    map.evaluate(spectral::tri_edge_point(edge, (1 + s) / 2), x, j);
    const Vec2 tangent = j * along;
    // n ds = (t_y, -t_x) ds and grad phi = J^-T grad_xi phi, so the flux is grad_xi phi . J^-1 (t_y, -t_x).
    const Vec2 direction = inverse(j) * Vec2{tangent.y, -tangent.x};
    terms.flux.col(q) = direction.x * table.d1[edge].col(q) + direction.y * table.d2[edge].col(q);
    terms.lengths[q] = norm(tangent);
    terms.weights[q] = table.rule.weights[q];
    trace_values(edge_order, s, terms.trace.col(q).data());
  }
  return terms;
}

double area(const spectral::TriMap& map) {
  if (map.is_affine()) {
    Vec2 x;
    Mat2 jacobian;
    map.evaluate({0, 0}, x, jacobian);
    return 2 * det(jacobian);
  }
  const int num_points = map.order();  // det J has degree 2 N - 2
  const spectral::Quadrature along = spectral::gauss_legendre(num_points),
                             up = spectral::gauss_jacobi(num_points, 1, 0);
  double sum = 0;
  for (int i = 0; i < num_points; ++i) {
    for (int j = 0; j < num_points; ++j) {
      Vec2 x;
      Mat2 jacobian;
      map.evaluate({(1 + along.points[i]) * (1 - up.points[j]) / 2 - 1, up.points[j]}, x, jacobian);
      sum += along.weights[i] * up.weights[j] / 2 * det(jacobian);
    }
  }
  return sum;
}

}  // namespace

void trace_values(int order, double s, double* values) {
  double previous = 0, current = 1;  // P_{d-1}, P_d
  for (int d = 0; d <= order; ++d) {
    values[d] = std::sqrt((2 * d + 1) / 2.0) * current;
    const double next = ((2 * d + 1) * s * current - d * previous) / (d + 1);
    previous = std::exchange(current, next);
  }
}

stiffness::CondensedElement condense_to_trace(const spectral::TriMap& map, int order,
                                              const std::array<int, 3>& edge_orders, const Eigen::MatrixXd& stiffness,
                                              double penalty) {
  const int highest = std::max({order, edge_orders[0], edge_orders[1], edge_orders[2]});
  const int num_points = highest + (map.is_affine() ? 1 : 1 + map.order());
  std::array<EdgeTerms, 3> edges;
  double circumference = 0;
  int num_trace = 0;
  for (int k = 0; k < 3; ++k) {
    edges[k] = edge_terms(map, order, k, edge_orders[k], num_points);
    circumference += edges[k].weights.dot(edges[k].lengths);
    num_trace += num_trace_modes(edge_orders[k]);
  }
  const double tau = penalty * order * (order + 1) / 2 * circumference / area(map);

  Eigen::MatrixXd inside = stiffness;
  Eigen::MatrixXd coupling(stiffness.rows(), num_trace);
  Eigen::MatrixXd on_trace = Eigen::MatrixXd::Zero(num_trace, num_trace);
  int first = 0;
  for (const EdgeTerms& e : edges) {
    const int m = static_cast<int>(e.trace.rows());
    const Eigen::VectorXd mass = tau * e.weights.cwiseProduct(e.lengths);
    // With half of the penalty in each of the two transposed factors, -N - N^T + tau M is one symmetric sum.
    const Eigen::MatrixXd half = e.values * mass.asDiagonal() / 2 - e.flux * e.weights.asDiagonal();
    const Eigen::MatrixXd product = half * e.values.transpose();
    inside += product + product.transpose();
    coupling.middleCols(first, m) =
        (e.flux * e.weights.asDiagonal() - e.values * mass.asDiagonal()) * e.trace.transpose();
    on_trace.block(first, first, m, m) = e.trace * mass.asDiagonal() * e.trace.transpose();
    first += m;
  }

  return stiffness::eliminate_interior(inside, coupling, on_trace,
                                       "an element's penalty form is not positive definite");
}

}  // namespace quadrille::galerkin
