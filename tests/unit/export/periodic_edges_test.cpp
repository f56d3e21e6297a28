#include "export/periodic_edges.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "periodic_row.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

PeriodicVertices vertices_of(const QuadMesh& mesh) {
  return periodic_vertices(mesh, number_parts(mesh), Motions::all, "the reader");
}

TEST(PeriodicVertices, BothEndsOfARowAreOne) {
  // Corner by corner: 0 1 2 3, then 4 5 and 6 7 on the right of the second and third square.
  const PeriodicVertices vertices = vertices_of(periodic_row(3));
  EXPECT_EQ(vertices.same, (std::vector{0, 1, 2, 3, 4, 5, 0, 3}));
  EXPECT_TRUE(vertices.are_identified());
  EXPECT_EQ(vertices(6), 0);
  EXPECT_EQ(vertices.loss, "");
}

TEST(PeriodicVertices, TheFourCornersOfADoublyPeriodicBoxAreOne) {
  QuadMesh mesh;  // 3 x 3 unit squares
  mesh.order = 1;
  mesh.face.diameter = 3;
  mesh.face.curves.resize(4);
  mesh.face.curve_names = {"low", "right", "high", "left"};
  mesh.face.periodic_pairs = {{{3, 1}, 0, {3, 0}}, {{0, 2}, 0, {0, 3}}};
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) mesh.nodes.push_back({1.0 * i, 1.0 * j});
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      for (const int node : {0, 1, 4, 5}) mesh.elem_nodes.push_back(4 * j + i + node);
      mesh.elem_block.push_back(0);
    }
  for (int k = 0; k < 3; ++k) mesh.boundary_edges.push_back({k, 0, 0});
  for (int k = 0; k < 3; ++k) mesh.boundary_edges.push_back({3 * k + 2, 1, 1});
  for (int k = 2; k >= 0; --k) mesh.boundary_edges.push_back({6 + k, 2, 2});
  for (int k = 2; k >= 0; --k) mesh.boundary_edges.push_back({3 * k, 3, 3});
  const EdgeNumbering numbering = number_parts(mesh);
  const PeriodicVertices vertices = periodic_vertices(mesh, numbering, Motions::all, "the reader");
  for (int v = 0; v < 16; ++v) {
    const Vec2 x = mesh.nodes[numbering.vertices[v]], same = mesh.nodes[numbering.vertices[vertices(v)]];
    EXPECT_EQ(same.x, x.x == 3 ? 0 : x.x);
    EXPECT_EQ(same.y, x.y == 3 ? 0 : x.y);
  }
}

TEST(PeriodicVertices, SidesThatAreTurnedMayBeLeftOut) {
  QuadMesh mesh = periodic_row(3);
  mesh.face.periodic_pairs = {{{3, 1}, 2 * pi, {3, 0}}};
  const EdgeNumbering numbering = number_parts(mesh);
  EXPECT_TRUE(periodic_vertices(mesh, numbering, Motions::all, "the reader").are_identified());
  EXPECT_FALSE(periodic_vertices(mesh, numbering, Motions::translations, "the reader").are_identified());
}

TEST(PeriodicVertices, WithoutPeriodicSidesEachIsItsOwn) {
  const PeriodicVertices vertices = vertices_of(two_quads());
  EXPECT_FALSE(vertices.are_identified());
  EXPECT_EQ(vertices(5), 5);
  EXPECT_EQ(vertices.loss, "");
}

TEST(PeriodicVertices, EdgesThatTheirEndsWouldNotTellApartStayAsTheyAre) {
  for (const int n : {1, 2}) {
    const PeriodicVertices vertices = vertices_of(periodic_row(n));
    EXPECT_FALSE(vertices.are_identified());
    EXPECT_NE(
        vertices.loss.find("\"left\" and \"right\" (the reader identifies edges by their ends, and the edge from"),
        std::string::npos)
        << vertices.loss;
  }
}

}  // namespace

}  // namespace quadrille::exports
