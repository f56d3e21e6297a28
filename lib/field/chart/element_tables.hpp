#pragma once
// Values and derivatives of polynomials of one order on the reference triangle, at the points of a quadrature rule and
// along its edges: from values at nodes (spectral/tri_map), and from coefficients of the modified basis.

#include <Eigen/Dense>
#include <array>

#include "base/vec2.hpp"

namespace quadrille::chart {

/// Gauss points along local edge k, from vertex k to k + 1; s in [-1, 1].
struct EdgeTable {
  Eigen::VectorXd points, weights;
  Eigen::MatrixXd from_nodes, derivative;  ///< points x nodes: values and derivatives with respect to s
  Eigen::MatrixXd from_modes;              ///< points x modes
};

struct ElementTables {
  /// `order`: P >= 1.
  explicit ElementTables(int order);

  int order = 1;
  Eigen::VectorXd weights;                           ///< of the rule, on the reference triangle
  Eigen::MatrixXd from_nodes, nodes_xi1, nodes_xi2;  ///< points x nodes: values and derivatives
  Eigen::MatrixXd modes_xi1, modes_xi2, from_modes;  ///< points x modes: derivatives and values
  Eigen::MatrixXd at_nodes_xi1, at_nodes_xi2;        ///< nodes x nodes: derivatives
  Eigen::MatrixXd nodes_from_modes;                  ///< nodes x modes
  Eigen::MatrixXd modes_from_nodes;                  ///< of the orthogonal basis
  std::array<EdgeTable, 3> edges;
};

/// The values at xi of the polynomials that are 1 at one node and 0 at the others.
Eigen::RowVectorXd node_functions(const ElementTables& tables, Vec2 xi);

/// Made once per order.
const ElementTables& element_tables(int order);

}  // namespace quadrille::chart
