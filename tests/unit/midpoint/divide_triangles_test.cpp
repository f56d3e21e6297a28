#include "midpoint/divide_triangles.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../samples.hpp"
#include "midpoint/doubtful_triangles.hpp"

namespace quadrille::midpoint {
namespace {

double bound_of(const SeparatrixGraph& graph, const std::array<HalfEdge, 4>& sides) {
  return jacobian_bound(curve::CurveTable(graph.face, graph.splines), graph, sides);
}

/// A face that is one triangle, counter-clockwise.
TriMesh triangle(const std::array<Vec2, 3>& p) {
  TriMesh mesh;
  for (int k = 0; k < 3; ++k) {
    mesh.face.curves.push_back(samples::line(p[k], p[(k + 1) % 3]));
    mesh.face.joints.push_back({p[k], 0, 0, 1, true});
    mesh.boundary_edges.push_back({0, k, k, 0, 1});
  }
  mesh.face.loop_offsets = {0, 3};
  mesh.vertices = {p.begin(), p.end()};
  mesh.elem2vertices = {{0, 1, 2}};
  return mesh;
}

TEST(DivideTriangles, FourTrianglesOfASquareMakeTwelveBlocks) {
  const DividedTriangles divided = divide_triangles(samples::tri_mesh());
  const SeparatrixGraph& graph = divided.graph;
  ASSERT_EQ(graph.nodes.size(), 5u + 8 + 4);
  EXPECT_EQ(graph.arcs.size(), 2u * 8 + 3 * 4);
  EXPECT_EQ(divided.blocks.size(), 4u);
  EXPECT_EQ(index_sum_of(graph), 4);
  for (int v = 0; v < 4; ++v) {
    EXPECT_EQ(graph.nodes[v].kind, NodeKind::corner);
    EXPECT_EQ(graph.nodes[v].valence, 2);
    EXPECT_EQ(graph.nodes[v].curve, v);
  }
  EXPECT_EQ(graph.nodes[4].kind, NodeKind::crossing);  // four triangles around it
  EXPECT_EQ(graph.nodes.back().valence, 3);
}

TEST(DivideTriangles, SidesOfBlocksJoinCounterClockwise) {
  const DividedTriangles divided = divide_triangles(samples::tri_mesh());
  const auto& arcs = divided.graph.arcs;
  for (std::size_t elem = 0; elem < divided.blocks.size(); ++elem)
    for (int k = 0; k < 3; ++k) {
      const std::array<HalfEdge, 4>& sides = divided.blocks[elem][k];
      EXPECT_EQ(start_of(arcs, sides[0]), samples::tri_mesh().elem2vertices[elem][k]);
      for (int i = 0; i < 4; ++i) EXPECT_EQ(end_of(arcs, sides[i]), start_of(arcs, sides[(i + 1) % 4]));
      EXPECT_GT(bound_of(divided.graph, sides), 0);
    }
}

// The coefficients are 1/4, 1/6, 1/6 and 1/12 of the triangle's determinant.
TEST(DivideTriangles, TheLeastJacobianOfAStraightTriangleIsATwelfth) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 200; ++i) {
    std::array<Vec2, 3> p;
    for (Vec2& x : p) x = {coordinate(random), coordinate(random)};
    double determinant = cross(p[1] - p[0], p[2] - p[0]);
    if (determinant < 0) std::swap(p[1], p[2]), determinant = -determinant;
    const DividedTriangles divided = divide_triangles(triangle(p));
    for (const auto& sides : divided.blocks[0])
      EXPECT_NEAR(bound_of(divided.graph, sides), determinant / 12, 1e-9 * determinant + 1e-11);
  }
}

TEST(DivideTriangles, ABulgingEdgeMovesTheCentreByFourNinths) {
  TriMesh mesh = triangle({{{0, 0}, {2, 0}, {0, 2}}});
  mesh.face.curves[0] = {2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, -0.6}, {2, 0}}, {1, 1, 1}};  // bulges by 0.3
  const SeparatrixGraph graph = divide_triangles(mesh).graph;
  EXPECT_NEAR(graph.nodes.back().position.x, 2.0 / 3, 1e-12);
  EXPECT_NEAR(graph.nodes.back().position.y, 2.0 / 3 - 0.3 * 4 / 9, 1e-12);
}

}  // namespace
}  // namespace quadrille::midpoint
