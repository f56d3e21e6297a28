#include "draw/elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"
#include "../test_meshes.hpp"
#include "small_picture.hpp"

namespace quadrille::draw {
namespace {

TEST(Elements, MapsAreThoseOfTheVerticesOrOfTheCurvedNodes) {
  const TriMesh mesh = disc_mesh(5, 6);
  const std::vector<spectral::TriMap> maps = element_maps(mesh);
  ASSERT_EQ(maps.size(), 5u);
  for (int e = 0; e < 5; ++e) {
    EXPECT_FALSE(maps[e].is_affine());
    EXPECT_NEAR(norm(maps[e].position(spectral::tri_edge_point(1, 0.5))), 1, 1e-6) << "on the circle";
  }
  TriMesh mixed = samples::tri_mesh();  // its first element is curved, the others are not
  const std::vector<spectral::TriMap> all = element_maps(mixed);
  for (int e = 0; e < 4; ++e)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(distance(all[e].position(std::array{Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}}[k]),
                           mixed.vertices[mixed.elem2vertices[e][k]]),
                  0, 1e-14);
  EXPECT_TRUE(all[1].is_affine());
}

TEST(Elements, AStraightTriangleIsClosedByThePathItself) {
  const spectral::TriMap map({Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}});
  const std::string path = tri_outline(small_picture(), map).str();
  EXPECT_EQ(std::count(path.begin(), path.end(), 'C'), 0) << path;
  EXPECT_EQ(path.back(), 'z');
  EXPECT_TRUE(path.starts_with("M0 0")) << path;
}

TEST(Elements, ACurvedSideIsACurve) {
  const std::string path = tri_outline(small_picture(), element_maps(disc_mesh(5, 6))[0]).str();
  EXPECT_GE(std::count(path.begin(), path.end(), 'C'), 1) << path;
}

TEST(Elements, SideNodesRunCounterClockwiseFromTheFirstCorner) {
  QuadMesh mesh;
  mesh.order = 2;
  for (int k = 0; k < 9; ++k) mesh.elem_nodes.push_back(k);
  const auto side = [&](int s) {
    return std::array{quad_side_node(mesh, 0, s, 0), quad_side_node(mesh, 0, s, 1), quad_side_node(mesh, 0, s, 2)};
  };
  EXPECT_EQ(side(0), (std::array{0, 1, 2}));
  EXPECT_EQ(side(1), (std::array{2, 5, 8}));
  EXPECT_EQ(side(2), (std::array{8, 7, 6}));
  EXPECT_EQ(side(3), (std::array{6, 3, 0}));
}

TEST(Elements, ASideIsThePolynomialThroughItsNodes) {
  // y = x^2 on the lower side of an element of order 2.
  QuadMesh mesh;
  mesh.order = 2;
  for (const double y : {-1.0, 0.0, 1.0})
    for (const double x : {-1.0, 0.0, 1.0}) mesh.nodes.push_back({x, y == -1 ? x * x - 1 : y});
  for (int k = 0; k < 9; ++k) mesh.elem_nodes.push_back(k);
  mesh.elem_block = {0};
  const PixelCurve curve = quad_side(small_picture(), mesh, 0, 0);
  for (const double s : {0.0, 0.3, 0.5, 1.0}) {
    const double x = 2 * s - 1;
    EXPECT_NEAR(distance(curve(s).position, {10 * (x + 1), 10 * x * x}), 0, 1e-12);
    EXPECT_NEAR(distance(curve(s).derivative, {20, 40 * x}), 0, 1e-12);
  }
  const std::string path = quad_outline(small_picture(), mesh, 0).str();
  EXPECT_EQ(path.back(), 'z');
  EXPECT_GE(std::count(path.begin(), path.end(), 'C'), 1);
}

}  // namespace
}  // namespace quadrille::draw
