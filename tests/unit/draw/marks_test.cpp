#include "draw/marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "../test_meshes.hpp"
#include "mesh/tri_topology.hpp"
#include "small_picture.hpp"

namespace quadrille::draw {

namespace {

std::string path_of(const Nurbs& curve, double t0, double t1) {
  PathData path;
  append_nurbs(path, small_picture(), curve, t0, t1);
  return path.str();
}

TEST(Marks, EachPieceOfASplineEndsWithItsOwnTangent) {
  // Two parabolas that meet at a right angle; each is one cubic exactly, but not with a tangent of the other.
  const Nurbs angle{2, {0, 0, 0, 1, 1, 2, 2, 2}, {{-1, -1}, {1, -1}, {1, 0}, {-1, 0}, {-1, 1}}, {1, 1, 1, 1, 1}};
  for (const auto& [from, to] : {std::pair{0.0, 2.0}, {2.0, 0.0}}) {
    const std::string path = path_of(angle, from, to);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'C'), 2) << path;
  }
}

TEST(Elements, AStraightTriangleIsClosedByThePathItself) {
  const spectral::TriMap map({Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}});
  const std::string path = tri_outline(small_picture(), map).str();
  EXPECT_EQ(std::count(path.begin(), path.end(), 'C'), 0) << path;
  EXPECT_EQ(path.back(), 'z');
  EXPECT_TRUE(path.starts_with("M0 0")) << path;
}

TEST(Elements, ACurvedSideIsACurve) {
  const std::string path = tri_outline(small_picture(), mesh::tri_maps(disc_mesh(5, 6))[0]).str();
  EXPECT_GE(std::count(path.begin(), path.end(), 'C'), 1) << path;
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
