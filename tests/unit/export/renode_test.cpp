#include "export/renode.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

/// The square [-1, 1]^2 and its right neighbour, of any order, with nodes at the images of the reference points.
QuadMesh two_squares(int order, const std::function<Vec2(Vec2)>& map) {
  const std::vector<double>& gll = spectral::gll_points(order);
  QuadMesh mesh = two_quads();
  mesh.order = order;
  mesh.nodes.clear(), mesh.elem_nodes.clear();
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= 2 * order; ++i) mesh.nodes.push_back(map({i <= order ? gll[i] : 2 + gll[i - order], gll[j]}));
  for (const int first : {0, order})
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i <= order; ++i) mesh.elem_nodes.push_back(first + j * (2 * order + 1) + i);
  return mesh;
}

std::vector<double> even_points(int order) {
  std::vector<double> points;
  for (int i = 0; i <= order; ++i) points.push_back(-1 + 2.0 * i / order);
  return points;
}

Eigen::MatrixXd to_even(int order) {
  return spectral::interpolation_matrix(spectral::gll_points(order), even_points(order));
}

/// Of degree 2 in each variable.
Vec2 bent(Vec2 xi) { return {xi.x + 0.1 * xi.y * xi.y - 0.05 * xi.x * xi.x * xi.y, xi.y + 0.2 * xi.x * xi.x}; }

TEST(Renode, PolynomialsAreExactAtTheNewNodes) {
  for (const int order : {2, 3, 5, 8}) {
    const QuadMesh mesh = two_squares(order, bent);
    const std::vector<Vec2> moved = renoded(mesh, to_even(order));
    const std::vector<double> even = even_points(order);
    for (int elem = 0; elem < 2; ++elem)
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i) {
          const int node = mesh.elem_nodes[elem * mesh.nodes_per_elem() + j * (order + 1) + i];
          EXPECT_NEAR(distance(moved[node], bent({even[i] + 2 * elem, even[j]})), 0, 1e-13) << order;
        }
  }
}

TEST(Renode, VerticesKeepEveryBit) {
  const int order = 5;
  const QuadMesh mesh = two_squares(order, [](Vec2 x) { return Vec2{x.x / 3, x.y / 7}; });
  const std::vector<Vec2> moved = renoded(mesh, to_even(order));
  for (const int i : {0, order, 2 * order})
    for (const int j : {0, order}) EXPECT_EQ(moved[j * (2 * order + 1) + i], mesh.nodes[j * (2 * order + 1) + i]);
}

TEST(Renode, TheIdentityMovesNothingAndOrderOneHasNothingToMove) {
  const QuadMesh mesh = two_squares(4, bent);
  const std::vector<Vec2> same = renoded(mesh, Eigen::MatrixXd::Identity(5, 5));
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) EXPECT_NEAR(distance(same[n], mesh.nodes[n]), 0, 1e-15);
  const QuadMesh straight = two_straight_quads();
  EXPECT_EQ(renoded(straight, Eigen::MatrixXd::Zero(2, 2)), straight.nodes);
}

TEST(Renode, ASideBetweenTheSameVerticesTwiceIsMovedOnceEach) {
  // Both sides of the ring's quads between (1, 0) and (-1, 0) have nodes of their own.
  const QuadMesh ring = ring_of_two_quads();
  Eigen::MatrixXd bernstein = Eigen::MatrixXd::Identity(3, 3);
  bernstein.row(1) << -0.5, 2, -0.5;
  const std::vector<Vec2> control = renoded(ring, bernstein);
  for (const auto& [low, middle, high] : {std::array{0, 3, 6}, {6, 9, 0}, {2, 5, 8}})
    EXPECT_NEAR(distance(control[middle], 2 * ring.nodes[middle] - (ring.nodes[low] + ring.nodes[high]) / 2), 0, 1e-15);
}

}  // namespace
}  // namespace quadrille::exports
