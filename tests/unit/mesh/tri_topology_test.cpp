#include "mesh/tri_topology.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::mesh {
namespace {

// 3---2
// | / |   element 0 = (0, 1, 2), element 1 = (0, 2, 3)
// 0---1
TriMesh two_triangles() {
  TriMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  mesh.boundary_edges = {{0, 0, 0, 0, 1}, {0, 1, 1, 0, 1}, {1, 1, 2, 0, 1}, {1, 2, 3, 0, 1}};
  return mesh;
}

TEST(TriTopology, TwoTrianglesShareTheirDiagonal) {
  const TriTopology topology = tri_topology(two_triangles());
  const std::vector<std::array<int, 2>> edges{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}};
  EXPECT_EQ(topology.edge2vertices, edges);
  EXPECT_EQ(topology.edge2elems[1], (std::array<int, 2>{0, 1}));
  EXPECT_EQ(topology.edge2elems[0], (std::array<int, 2>{0, -1}));
  EXPECT_EQ(topology.elem2edges[0], (std::array<int, 3>{0, 3, 1}));
  EXPECT_EQ(topology.elem2edges[1], (std::array<int, 3>{1, 4, 2}));
  EXPECT_EQ(topology.elem2neighbors[0], (std::array<int, 3>{-1, -1, 1}));
  EXPECT_EQ(topology.elem2neighbors[1], (std::array<int, 3>{0, -1, -1}));
  EXPECT_EQ(topology.elem2neighbor_edges[0], (std::array<int, 3>{-1, -1, 0}));
  EXPECT_EQ(topology.elem2neighbor_edges[1], (std::array<int, 3>{2, -1, -1}));
  EXPECT_EQ(topology.elem2boundary_edge[0], (std::array<int, 3>{0, 1, -1}));
  EXPECT_EQ(topology.elem2boundary_edge[1], (std::array<int, 3>{-1, 2, 3}));
}

TEST(TriTopology, RefusesAnEdgeOfThreeElements) {
  TriMesh mesh = two_triangles();
  mesh.vertices.push_back({2, 2});
  mesh.elem2vertices.push_back({2, 0, 4});
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesNeighboursOfOppositeOrientation) {
  TriMesh mesh = two_triangles();
  mesh.elem2vertices[1] = {2, 0, 3};
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesAnElementThatUsesAVertexTwice) {
  TriMesh mesh = two_triangles();
  mesh.elem2vertices[1] = {0, 2, 2};
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesAMissingBoundaryEdge) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.pop_back();
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesABoundaryEdgeNamedTwice) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.push_back(mesh.boundary_edges.front());
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesAnInnerEdgeAsBoundary) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.push_back({0, 2, 0, 0, 1});
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

TEST(TriTopology, RefusesABoundaryEdgeOfNoElement) {
  TriMesh mesh = two_triangles();
  mesh.boundary_edges.push_back({7, 0, 0, 0, 1});
  EXPECT_THROW(tri_topology(mesh), FormatError);
}

}  // namespace
}  // namespace quadrille::mesh
