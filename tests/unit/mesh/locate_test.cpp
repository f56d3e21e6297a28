#include "mesh/locate.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"

namespace quadrille::mesh {
namespace {

struct LocatorTest : testing::Test {
  TriMesh mesh = square_mesh({-1, 2}, 3, 5);
  std::vector<spectral::TriMap> maps = tri_maps(mesh);
  Locator locator{mesh, maps};
};

TEST_F(LocatorTest, finds_the_reference_point_of_every_element) {
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (const Vec2 xi : {Vec2{-0.9, -0.8}, Vec2{-1.0 / 3, -1.0 / 3}, Vec2{0.7, -0.9}, Vec2{-0.95, 0.9}}) {
      const Location at = locator.find(maps[e].position(xi));
      EXPECT_EQ(at.elem, e);
      EXPECT_NEAR(distance(at.xi, xi), 0, 1e-13);
    }
}

TEST_F(LocatorTest, takes_the_lowest_element_on_edges_and_vertices) {
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    int lowest = mesh.num_elems();
    for (int e = mesh.num_elems() - 1; e >= 0; --e)
      for (const int corner : mesh.elem2vertices[e])
        if (corner == v) lowest = e;
    EXPECT_EQ(locator.find(mesh.vertices[v]).elem, lowest);
  }
  EXPECT_EQ(locator.find((mesh.vertices[0] + mesh.vertices[7]) / 2).elem, 0);  // the first diagonal
}

TEST_F(LocatorTest, knows_the_outside) {
  for (const Vec2 x : {Vec2{-1.001, 3}, Vec2{2.5, 3}, Vec2{0, 1.9999}, Vec2{0, 9}, Vec2{std::nan(""), 3}})
    EXPECT_EQ(locator.find(x).elem, -1);
}

TEST_F(LocatorTest, finds_points_beside_the_mesh) {
  const Vec2 x{-1 - 1e-9, 3};
  EXPECT_EQ(locator.find(x).elem, -1);
  const Location at = locator.find(x, 1e-8);
  ASSERT_GE(at.elem, 0);
  EXPECT_NEAR(distance(maps[at.elem].position(at.xi), x), 0, 1e-13);
  EXPECT_EQ(locator.find(x, 1e-10).elem, -1);
  EXPECT_EQ(locator.distance_to_box(at.elem, x), 0) << "boxes have a margin";
  EXPECT_NEAR(locator.distance_to_box(at.elem, {-1.5, 3}), 0.5, 1e-7);
}

TEST_F(LocatorTest, walks_from_any_element_to_any_other) {
  const TriTopology topology = tri_topology(mesh);
  for (int from = 0; from < mesh.num_elems(); ++from)
    for (int to = 0; to < mesh.num_elems(); ++to) {
      const Vec2 xi{-0.4, -0.5};
      const Location at = walk(topology, maps, maps[to].position(xi), {from, {-0.9, 0.7}});
      EXPECT_EQ(at.elem, to);
      EXPECT_NEAR(distance(at.xi, xi), 0, 1e-12);
    }
}

TEST_F(LocatorTest, ends_a_walk_at_the_boundary) {
  const TriTopology topology = tri_topology(mesh);
  for (const Vec2 x : {Vec2{-1.001, 3}, Vec2{2.5, 3}, Vec2{0, 1.9999}, Vec2{0, 9}, Vec2{std::nan(""), 3}})
    EXPECT_EQ(walk(topology, maps, x, {7, {0, -1}}).elem, -1);
  EXPECT_EQ(walk(topology, maps, {0, 3}, {}).elem, -1);  // from nowhere
}

// A thousand points on the common edge of two elements of 1e-7 diameters: round-off puts some of them outside both.
TEST(Locator, finds_points_between_tiny_elements) {
  TriMesh mesh = square_mesh({0.3, 0.7}, 1e-7, 1);
  mesh.face.diameter = 1;
  const std::vector<spectral::TriMap> maps = tri_maps(mesh);
  const Locator locator{mesh, maps};
  for (int i = 0; i < 1000; ++i) {
    const Vec2 xi{-1 + (i + 0.5) / 500, -1}, opposite{-1, -1 + (i + 0.5) / 500};
    for (const Vec2 side : {xi, opposite, Vec2{xi.x, -xi.x}}) EXPECT_GE(locator.find(maps[0].position(side)).elem, 0);
  }
  EXPECT_EQ(locator.find({0.3 + 0.5e-7, 0.7 - 1e-13}).elem, -1);
}

TEST(Locator, inverts_curved_elements) {
  // Two order-3 triangles that share the arc y = x (1 - x) / 2 between (0,0) and (1,0).
  const auto bend = [](Vec2 p) { return p + Vec2{0, p.x * (1 - p.x) / 2}; };
  TriMesh mesh;
  mesh.order = 3;
  mesh.face.diameter = 2;
  mesh.vertices = {{0, 0}, {1, 0}, {0, 1}, {1, -1}};
  mesh.elem2vertices = {{0, 1, 2}, {1, 0, 3}};
  mesh.curved_elems = {0, 1};
  for (const auto& [a, b, c] : mesh.elem2vertices) {
    const spectral::TriMap straight({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    for (const Vec2 xi : spectral::tri_nodes(3)) mesh.curved_nodes.push_back(bend(straight.position(xi)));
  }
  const std::vector<spectral::TriMap> maps = tri_maps(mesh);
  const Locator locator(mesh, maps);
  for (const Vec2 xi : {Vec2{0, -0.99}, Vec2{-0.5, -0.7}, Vec2{-0.9, 0.8}})
    for (int e = 0; e < 2; ++e) {
      const Location at = locator.find(maps[e].position(xi));
      EXPECT_EQ(at.elem, e);
      EXPECT_NEAR(distance(at.xi, xi), 0, 1e-12);
    }
  EXPECT_EQ(locator.find({0.5, 0.7}).elem, -1);  // beyond the bent hypotenuse
}

}  // namespace
}  // namespace quadrille::mesh
