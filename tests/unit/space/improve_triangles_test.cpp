#include "space/improve_triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec3.hpp"
#include "grid_face.hpp"
#include "space/boundary_loops.hpp"

namespace quadrille::space {

namespace {

double least_shape(const RawSpaceFace& raw) {
  double least = 1;
  for (const auto& t : raw.triangles) {
    const Vec3 &a = raw.vertices[t[0]], &b = raw.vertices[t[1]], &c = raw.vertices[t[2]];
    const double area = cross(b - a, c - a).z;
    least = std::min(least, 2 * std::sqrt(3.0) * area / (norm2(b - a) + norm2(c - b) + norm2(a - c)));
  }
  return least;
}

// A vertex next to a side makes a triangle without area.
TEST(ImproveTriangles, bad_triangles_inside_a_plane_disappear) {
  RawSpaceFace raw = grid_face(flat_square(), 3);
  const Vec2 uv{0.5, 1e-9};
  raw.vertices[5] = surface::point(raw.surface, uv);
  for (std::size_t t = 0; t < raw.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (raw.triangles[t][k] == 5) raw.triangle_uv[t][k] = uv;
  EXPECT_LT(least_shape(raw), 1e-6);
  improve_triangles(raw);
  EXPECT_GT(least_shape(raw), 0.05);
  EXPECT_EQ(boundary_loops(raw).front().size(), 4U);
}

// The quarter of a cylinder whose sides are chords of its arcs.
TEST(ImproveTriangles, triangles_come_near_to_the_surface) {
  RawSpaceFace raw = grid_face(flat_square(), 2);
  raw.surface = {2,
                 1,
                 {0, 0, 0, 1, 1, 1},
                 {0, 0, 1, 1},
                 {{0, 0, 0}, {0, 2, 0}, {1, 0, 1}, {1, 2, 1}, {2, 0, 0}, {2, 2, 0}},
                 {1, 1, std::sqrt(0.5), std::sqrt(0.5), 1, 1},
                 false,
                 false};
  for (std::size_t t = 0; t < raw.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) raw.vertices[raw.triangles[t][k]] = surface::point(raw.surface, raw.triangle_uv[t][k]);
  for (const int edge : {0, 2}) {
    const double y = edge == 0 ? 0 : 2;
    raw.curves[edge] = {2, {0, 0, 0, 1, 1, 1}, {{0, y, 0}, {1, y, 1}, {2, y, 0}}, {1, std::sqrt(0.5), 1}};
  }
  improve_triangles(raw);
  for (std::size_t t = 0; t < raw.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 middle = (raw.vertices[raw.triangles[t][k]] + raw.vertices[raw.triangles[t][(k + 1) % 3]]) / 2.0;
      const double radius = std::hypot(middle.x - 1, middle.z + 1);
      EXPECT_NEAR(radius, std::sqrt(2.0), 0.01);
    }
  EXPECT_EQ(boundary_loops(raw).front().size(), 4U);
}

}  // namespace

}  // namespace quadrille::space
