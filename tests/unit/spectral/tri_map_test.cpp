#include "spectral/tri_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

const std::array<Vec2, 3> triangle{Vec2{1, 2}, Vec2{4, 2.5}, Vec2{1.5, 5}};

Vec2 bent(Vec2 xi) { return {xi.x + 0.2 * xi.y * xi.y, xi.y + 0.1 * xi.x * xi.x * xi.y - 0.05 * xi.x}; }

TriMap bent_map(int order) {
  std::vector<Vec2> nodes;
  for (const Vec2 xi : tri_nodes(order)) nodes.push_back(bent(xi));
  return TriMap(order, nodes.data());
}

TEST(TriMap, AffineMapHitsVerticesAndItsCoefficientsAgree) {
  const TriMap map(triangle);
  EXPECT_TRUE(map.is_affine());
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(distance(map.position(tri_edge_point(k, 0)), triangle[k]), 0, 1e-15);
  const Vec2 xi{-0.3, 0.1};
  const Vec2 sum = orthogonal_sum(1, map.coefs_x().data(), map.coefs_y().data(), xi);
  EXPECT_NEAR(distance(map.position(xi), sum), 0, 1e-14);
}

TEST(TriMap, CurvedMapReproducesAPolynomialMapAndItsJacobian) {
  for (const int order : {3, 5, 8, 12}) {
    const TriMap map = bent_map(order);
    for (const Vec2 xi : {Vec2{-1, -1}, Vec2{-0.3, 0.1}, Vec2{0.2, -0.7}}) {
      Vec2 x;
      Mat2 jacobian;
      map.evaluate(xi, x, jacobian);
      EXPECT_NEAR(distance(x, bent(xi)), 0, 1e-14);
      EXPECT_NEAR(distance(map.position(xi), bent(xi)), 0, 1e-14);
      EXPECT_NEAR(jacobian.xx, 1, 1e-12);
      EXPECT_NEAR(jacobian.xy, 0.4 * xi.y, 1e-12);
      EXPECT_NEAR(jacobian.yx, 0.2 * xi.x * xi.y - 0.05, 1e-12);
      EXPECT_NEAR(jacobian.yy, 1 + 0.1 * xi.x * xi.x, 1e-12);
    }
  }
}

TEST(TriMap, InvertUndoesPosition) {
  const TriMap curved = bent_map(6), affine(triangle);
  for (const TriMap* map : {&curved, &affine}) {
    for (const Vec2 xi : {Vec2{-1, 1}, Vec2{-0.3, 0.1}, Vec2{0.9, -0.95}, Vec2{0.3, 0.2}}) {
      Vec2 found{-1.0 / 3, -1.0 / 3};
      EXPECT_TRUE(map->invert(map->position(xi), found));
      EXPECT_NEAR(distance(found, xi), 0, 1e-13);
    }
  }
}

TEST(TriMap, InvertSaysWhenItFailed) {
  Vec2 xi{-1.0 / 3, -1.0 / 3};
  EXPECT_FALSE(bent_map(4).invert({1e6, 1e6}, xi));
}

TEST(TriMap, EdgePointsWalkCounterClockwise) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(distance(tri_edge_point(k, 1), tri_edge_point((k + 1) % 3, 0)), 0, 0);
    EXPECT_NEAR(distance(tri_edge_point(k, 0.5), (tri_edge_point(k, 0) + tri_edge_point(k, 1)) / 2), 0, 1e-16);
  }
}

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
