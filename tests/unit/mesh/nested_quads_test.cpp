#include "mesh/nested_quads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "mesh/element_sizes.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::mesh {
namespace {

/// Two elements of a sector between the radii 1 and 2, from the angle 0 to half a turn.
QuadMesh half_ring(int order) {
  QuadMesh mesh;
  mesh.order = order;
  const std::vector<double>& points = spectral::gll_points(order);
  const int width = 2 * order + 1;
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i < width; ++i) {
      const int column = std::min(i / order, 1);
      const double angle = half_pi * (column + (points[i - column * order] + 1) / 2), r = 2 - (points[j] + 1) / 2;
      mesh.nodes.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
  for (int column = 0; column < 2; ++column) {
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i <= order; ++i) mesh.elem_nodes.push_back(j * width + column * order + i);
    mesh.elem_block.push_back(column);
  }
  mesh.boundary_edges = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {1, 2, 2}, {0, 2, 2}, {0, 3, 3}};
  return mesh;
}

Vec2 at(const QuadMesh& mesh, int elem, double x, double y) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  const Eigen::MatrixXd a = spectral::interpolation_matrix(points, {x}),
                        b = spectral::interpolation_matrix(points, {y});
  Vec2 position;
  for (int j = 0; j <= mesh.order; ++j)
    for (int i = 0; i <= mesh.order; ++i)
      position +=
          a(0, i) * b(0, j) * mesh.nodes[mesh.elem_nodes[elem * mesh.nodes_per_elem() + j * (mesh.order + 1) + i]];
  return position;
}

TEST(NestedQuads, ChildrenAreThePartsOfTheParentsMap) {
  for (const int order : {1, 2, 5}) {
    const QuadMesh coarse = half_ring(order), fine = nested_quads(coarse, 2);
    ASSERT_EQ(fine.num_elems(), 32);
    for (int child = 0; child < fine.num_elems(); ++child) {
      const int parent = child / 16, column = child % 4, row = child % 16 / 4;
      EXPECT_EQ(fine.elem_block[child], parent);
      for (const Vec2 xi : {Vec2{-0.3, 0.8}, {0.9, -1}, {1, 0.2}}) {
        const Vec2 expected = at(coarse, parent, -1 + (column + (1 + xi.x) / 2) / 2, -1 + (row + (1 + xi.y) / 2) / 2);
        EXPECT_LT(distance(at(fine, child, xi.x, xi.y), expected), 1e-13) << order;
      }
    }
  }
}

TEST(NestedQuads, VerticesAreKeptBitForBitAndLevelsAreNested) {
  const QuadMesh coarse = half_ring(4), once = nested_quads(coarse, 1), twice = nested_quads(coarse, 2);
  const auto corner = [](const QuadMesh& mesh, int elem, int k) {
    const int n = mesh.order, last = mesh.nodes_per_elem() - 1;
    return mesh.nodes[mesh.elem_nodes[elem * mesh.nodes_per_elem() + (k == 0   ? 0
                                                                      : k == 1 ? n
                                                                      : k == 2 ? last
                                                                               : last - n)]];
  };
  for (int e = 0; e < 2; ++e) {
    EXPECT_EQ(corner(once, 4 * e, 0), corner(coarse, e, 0));
    EXPECT_EQ(corner(once, 4 * e + 1, 1), corner(coarse, e, 1));
    EXPECT_EQ(corner(once, 4 * e + 3, 2), corner(coarse, e, 2));
    EXPECT_EQ(corner(once, 4 * e + 2, 3), corner(coarse, e, 3));
    EXPECT_EQ(corner(twice, 16 * e + 5, 2), corner(once, 4 * e, 2)) << "the middle of the element";
    EXPECT_EQ(corner(twice, 16 * e + 1, 1), corner(once, 4 * e, 1)) << "the middle of its side";
  }
}

TEST(NestedQuads, ElementsShareNodesAndBoundaryEdgesFollowEachOther) {
  const QuadMesh coarse = half_ring(3), fine = nested_quads(coarse, 1);
  EXPECT_EQ(fine.nodes.size(), 13u * 7u);  // 4 x 2 elements of order 3
  ASSERT_EQ(fine.boundary_edges.size(), 12u);
  const auto side_end = [&](const QuadBoundaryEdge& edge, int end) {
    const int corners[4] = {0, 3, 15, 12};
    return fine.elem_nodes[edge.elem * 16 + corners[(edge.side + end) % 4]];
  };
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(side_end(fine.boundary_edges[i], 1), side_end(fine.boundary_edges[(i + 1) % 12], 0)) << i;
    EXPECT_EQ(fine.boundary_edges[i].curve, coarse.boundary_edges[i / 2].curve);
  }
}

TEST(NestedQuads, NothingChangesWithoutLevels) {
  const QuadMesh coarse = half_ring(2);
  EXPECT_EQ(nested_quads(coarse, 0).elem_nodes, coarse.elem_nodes);
}

}  // namespace
}  // namespace quadrille::mesh
