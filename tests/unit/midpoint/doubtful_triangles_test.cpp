#include "midpoint/doubtful_triangles.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"

namespace quadrille::midpoint {
namespace {

/// A triangle whose lower side is a parabola that is higher by `rise` in its middle.
TriMesh triangle_above_parabola(double rise) {
  const std::array<Vec2, 3> p{{{0, 0}, {2, 0}, {1, 1}}};
  TriMesh mesh;
  for (int k = 0; k < 3; ++k) {
    mesh.face.curves.push_back(samples::line(p[k], p[(k + 1) % 3]));
    mesh.face.joints.push_back({p[k], 0, 0, 1, true});
    mesh.boundary_edges.push_back({0, k, k, 0, 1});
  }
  mesh.face.curves[0] = {2, {0, 0, 0, 1, 1, 1}, {p[0], {1, 2 * rise}, p[1]}, {1, 1, 1}};
  mesh.face.loop_offsets = {0, 3};
  mesh.vertices = {p.begin(), p.end()};
  mesh.elem2vertices = {{0, 1, 2}};
  mesh.curved_elems = {0};
  return mesh;
}

std::vector<int> doubtful(const TriMesh& mesh) { return doubtful_triangles(mesh, divide_triangles(mesh)); }

TEST(DoubtfulTriangles, ATriangleBesideAFlatCurveIsNot) {
  EXPECT_TRUE(doubtful(triangle_above_parabola(0.1)).empty());
  EXPECT_TRUE(doubtful(triangle_above_parabola(-0.2)).empty());
}

// The tangents of the parabola at its ends rise by 4 times its middle for each unit of length: steeper than the sides.
TEST(DoubtfulTriangles, ATriangleWhoseCurveLeavesItAtAVertexIs) {
  EXPECT_EQ(doubtful(triangle_above_parabola(0.6)), std::vector<int>{0});
}

TEST(DoubtfulTriangles, OnlyTrianglesWithACurvedEdgeAreMeasured) {
  TriMesh mesh = triangle_above_parabola(0.6);
  mesh.curved_elems.clear();
  EXPECT_TRUE(doubtful(mesh).empty());
}

}  // namespace
}  // namespace quadrille::midpoint
