#include "chart/element_tables.hpp"

#include <vector>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::chart {
namespace {

/// Metrics are no polynomials.
constexpr int points_beyond_order = 4;

/// Values and derivatives of the orthogonal basis: points x modes.
struct Basis {
  Basis(int order, const std::vector<Vec2>& points) {
    const auto n = static_cast<Eigen::Index>(points.size()), modes = Eigen::Index{spectral::num_tri_modes(order)};
    Eigen::MatrixXd v(modes, n), d1(modes, n), d2(modes, n);
    for (Eigen::Index i = 0; i < n; ++i)
      spectral::orthogonal_gradients(order, points[i], v.col(i).data(), d1.col(i).data(), d2.col(i).data());
    values = v.transpose(), xi1 = d1.transpose(), xi2 = d2.transpose();
  }
  Eigen::MatrixXd values, xi1, xi2;
};

}  // namespace

ElementTables::ElementTables(int table_order) : order(table_order) {
  const int n = order + points_beyond_order;
  const spectral::Quadrature eta1 = spectral::gauss_legendre(n), eta2 = spectral::gauss_jacobi(n, 1, 0);
  std::vector<Vec2> points;
  weights.resize(n * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      points.push_back({(1 + eta1.points[i]) * (1 - eta2.points[j]) / 2 - 1, eta2.points[j]});
      weights[i + n * j] = eta1.weights[i] * eta2.weights[j] / 2;
    }
  const Basis nodes(order, spectral::tri_nodes(order)), inside(order, points);
  const Eigen::MatrixXd from_values = nodes.values.inverse(),
                        from_modified = spectral::modified_to_orthogonal(order).transpose();
  from_nodes = inside.values * from_values;
  nodes_xi1 = inside.xi1 * from_values, nodes_xi2 = inside.xi2 * from_values;
  from_modes = inside.values * from_modified;
  modes_xi1 = inside.xi1 * from_modified, modes_xi2 = inside.xi2 * from_modified;
  at_nodes_xi1 = nodes.xi1 * from_values, at_nodes_xi2 = nodes.xi2 * from_values;
  nodes_from_modes = nodes.values * from_modified;
  modes_from_nodes = from_values;
  for (int k = 0; k < 3; ++k) {
    EdgeTable& edge = edges[k];
    edge.points = Eigen::Map<const Eigen::VectorXd>(spectral::gauss_legendre(n).points.data(), n);
    edge.weights = Eigen::Map<const Eigen::VectorXd>(spectral::gauss_legendre(n).weights.data(), n);
    std::vector<Vec2> along;
    for (const double s : edge.points) along.push_back(spectral::tri_edge_point(k, (1 + s) / 2));
    const Vec2 step = (spectral::tri_edge_point(k, 1) - spectral::tri_edge_point(k, 0)) / 2;
    const Basis basis(order, along);
    edge.from_nodes = basis.values * from_values;
    edge.derivative = (step.x * basis.xi1 + step.y * basis.xi2) * from_values;
    edge.from_modes = basis.values * from_modified;
  }
}

Eigen::RowVectorXd node_functions(const ElementTables& tables, Vec2 xi) {
  Eigen::RowVectorXd values(tables.modes_from_nodes.rows());
  spectral::orthogonal_values(tables.order, xi, values.data());
  return values * tables.modes_from_nodes;
}

const ElementTables& element_tables(int order) { return spectral::table_per_order<ElementTables>(order); }

}  // namespace quadrille::chart
