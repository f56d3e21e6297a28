#include "spectral/tri_nodes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {
namespace {

TEST(TriNodes, EdgesHoldTheGaussLobattoPoints) {
  for (int order = 1; order <= 16; ++order) {
    const std::vector<Vec2>& nodes = tri_nodes(order);
    ASSERT_EQ(static_cast<int>(nodes.size()), num_tri_modes(order));
    for (int j = 0; j <= order; ++j) {
      const double x = gll_points(order)[j];
      EXPECT_NEAR(distance(nodes[tri_edge_node(order, 0, j)], {x, -1}), 0, 1e-15);
      EXPECT_NEAR(distance(nodes[tri_edge_node(order, 1, j)], {-x, x}), 0, 1e-15);
      EXPECT_NEAR(distance(nodes[tri_edge_node(order, 2, j)], {-1, -x}), 0, 1e-15);
    }
  }
}

TEST(TriNodes, TheSetIsUnchangedByTheTrianglesSymmetries) {
  for (int order = 1; order <= 14; ++order) {
    const std::vector<Vec2>& nodes = tri_nodes(order);
    const auto holds = [&](Vec2 x) {
      return std::any_of(nodes.begin(), nodes.end(), [&](Vec2 node) { return distance(node, x) < 1e-13; });
    };
    for (const Vec2 x : nodes) {
      EXPECT_TRUE(holds({x.y, x.x}));             // swaps vertices 1 and 2
      EXPECT_TRUE(holds({x.y, -1 - x.x - x.y}));  // turns the triangle
      EXPECT_LE(x.x + x.y, 1e-15);
      EXPECT_GE(std::min(x.x, x.y), -1 - 1e-15);
    }
  }
}

TEST(TriNodes, InterpolationIsWellConditioned) {
  // The Lebesgue constants in Warburton (2006), table 1: 3.70 at order 6, 4.96 at 8, 9.36 at 12, 17.65 at 15.
  const auto bound = [](int order) { return order <= 6 ? 3.71 : order <= 8 ? 4.97 : order <= 12 ? 9.37 : 25.0; };
  for (int order = 2; order <= 16; ++order) {
    const Eigen::MatrixXd inverse = orthogonal_vandermonde(order, tri_nodes(order)).inverse();
    std::vector<double> f(num_tri_modes(order));
    double lebesgue = 0;
    for (double y = -1; y <= 1; y += 0.05) {
      for (double x = -1; x <= -y; x += 0.05) {
        orthogonal_values(order, {x, y}, f.data());
        const Eigen::Map<Eigen::VectorXd> row(f.data(), static_cast<Eigen::Index>(f.size()));
        lebesgue = std::max(lebesgue, (inverse.transpose() * row).lpNorm<1>());
      }
    }
    EXPECT_LT(lebesgue, bound(order)) << order;
  }
}

}  // namespace
}  // namespace quadrille::spectral
