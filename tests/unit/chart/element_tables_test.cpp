#include "chart/element_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "spectral/tri_map.hpp"

namespace quadrille::chart {
namespace {

/// Values of a function at the nodes.
template <class Function>
Eigen::VectorXd at_nodes(int order, const Function& f) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(spectral::tri_nodes(order).size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = f(spectral::tri_nodes(order)[i]);
  return values;
}

/// On the triangle -1 <= x, y, x + y <= 0 the integrals of 1, x and x y are 2, -2/3 and 0.
TEST(ElementTables, TheRuleIntegratesPolynomials) {
  for (const int order : {1, 3, 8}) {
    const ElementTables& tables = element_tables(order);
    EXPECT_NEAR(tables.weights.sum(), 2, 1e-13);
    const auto integral = [&](const auto& f) { return tables.weights.dot(tables.from_nodes * at_nodes(order, f)); };
    EXPECT_NEAR(integral([](Vec2 x) { return x.x; }), -2.0 / 3, 1e-13);
    if (order > 1) {
      EXPECT_NEAR(integral([](Vec2 x) { return x.x * x.y; }), 0, 1e-13);
    }
  }
}

TEST(ElementTables, DerivativesAreThoseOfPolynomials) {
  const ElementTables& tables = element_tables(4);
  const Eigen::VectorXd f = at_nodes(4, [](Vec2 x) { return x.x * x.x * x.y; }),
                        by_x = at_nodes(4, [](Vec2 x) { return 2 * x.x * x.y; }),
                        by_y = at_nodes(4, [](Vec2 x) { return x.x * x.x; });
  EXPECT_LT((tables.at_nodes_xi1 * f - by_x).norm(), 1e-12);
  EXPECT_LT((tables.at_nodes_xi2 * f - by_y).norm(), 1e-12);
  EXPECT_LT((tables.nodes_xi1 * f - tables.from_nodes * by_x).norm(), 1e-12);
}

/// Modes and nodes describe the same polynomials.
TEST(ElementTables, ModesHaveTheirValuesAtNodesAndPoints) {
  const ElementTables& tables = element_tables(5);
  EXPECT_LT((tables.from_nodes * tables.nodes_from_modes - tables.from_modes).norm(), 1e-11);
  EXPECT_LT((tables.nodes_xi2 * tables.nodes_from_modes - tables.modes_xi2).norm(), 1e-10);
}

TEST(ElementTables, EdgesRunFromVertexToVertex) {
  const ElementTables& tables = element_tables(3);
  const Eigen::VectorXd x = at_nodes(3, [](Vec2 at) { return at.x; }), y = at_nodes(3, [](Vec2 at) { return at.y; });
  const std::array<Vec2, 3> steps{{{2, 0}, {-2, 2}, {0, -2}}};
  for (int k = 0; k < 3; ++k) {
    const EdgeTable& edge = tables.edges[k];
    EXPECT_NEAR(edge.weights.sum(), 2, 1e-14);
    EXPECT_NEAR(edge.weights.dot(edge.derivative * x), steps[k].x, 1e-13) << k;
    EXPECT_NEAR(edge.weights.dot(edge.derivative * y), steps[k].y, 1e-13) << k;
    EXPECT_LT((edge.from_nodes * tables.nodes_from_modes - edge.from_modes).norm(), 1e-12);
  }
}

TEST(NodeFunctions, AreOneAtTheirNodeAndSumToOne) {
  const ElementTables& tables = element_tables(6);
  const Eigen::RowVectorXd at_node = node_functions(tables, spectral::tri_nodes(6)[7]);
  for (Eigen::Index i = 0; i < at_node.size(); ++i) EXPECT_NEAR(at_node[i], i == 7 ? 1 : 0, 1e-12);
  EXPECT_NEAR(node_functions(tables, {-0.3, -0.2}).sum(), 1, 1e-12);
}

}  // namespace
}  // namespace quadrille::chart
