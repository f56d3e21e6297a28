#include "chart/intrinsic_triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "space_faces.hpp"

namespace quadrille::chart {
namespace {

using tests::face_of;
using tests::line;
using tests::revolved;

IntrinsicTriangles triangles_of(const SpaceFace& face) {
  std::vector<SpaceLength> lengths;
  lengths.reserve(face.curves.size());
  for (const SpaceCurve& curve : face.curves) lengths.emplace_back(curve);
  return delaunay_triangles(face, lengths);
}

double cotangent_opposite(const IntrinsicTriangle& t, int side) {
  const double a = t.lengths[side], b = t.lengths[(side + 1) % 3], c = t.lengths[(side + 2) % 3];
  return (b * b + c * c - a * a) / std::sqrt((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c));
}

void expect_delaunay(const IntrinsicTriangles& fine) {
  for (const IntrinsicTriangle& t : fine.triangles)
    for (int k = 0; k < 3; ++k) {
      const int across = t.across[k];
      if (across < 0) continue;
      const IntrinsicTriangle& other = fine.triangles[across / 3];
      EXPECT_EQ(t.vertices[k], other.vertices[(across + 1) % 3]);
      EXPECT_EQ(t.lengths[k], other.lengths[across % 3]);
      EXPECT_GT(cotangent_opposite(t, k) + cotangent_opposite(other, across % 3), -1e-8);
    }
}

double area(const IntrinsicTriangles& fine) {
  double sum = 0;
  for (const IntrinsicTriangle& t : fine.triangles) {
    const auto& [a, b, c] = t.lengths;
    sum += std::sqrt((a + b + c) * (b + c - a) * (c + a - b) * (a + b - c)) / 4;
  }
  return sum;
}

SpaceFace cylinder_patch() { return face_of(revolved(line({1, 0, 0}, {1, 0, 3}), 0, 2), {{0, 1, 2, 3}}, 12, 1); }

TEST(IntrinsicTriangles, LongTrianglesOfACylinderBecomeShortOnes) {
  const IntrinsicTriangles fine = triangles_of(cylinder_patch());
  expect_delaunay(fine);
  for (const IntrinsicTriangle& t : fine.triangles)
    EXPECT_LT(*std::max_element(t.lengths.begin(), t.lengths.end()), 0.2);
  EXPECT_NEAR(area(fine), 6, 0.01);  // flips change no length
  for (const Vec3& x : fine.vertices) EXPECT_NEAR(std::hypot(x.x, x.y), 1, 1e-12);
}

TEST(IntrinsicTriangles, BoundaryEdgesFollowTheCurves) {
  const SpaceFace face = cylinder_patch();
  const IntrinsicTriangles fine = triangles_of(face);
  EXPECT_GT(fine.boundary_edges.size(), face.boundary_edges.size());
  for (const FineBoundaryEdge& edge : fine.boundary_edges) {
    EXPECT_LT(edge.t0, edge.t1);
    EXPECT_LT(distance(surface::point(face.curves[edge.curve], edge.t0), fine.vertices[edge.vertices[0]]), 1e-12);
    EXPECT_LT(distance(surface::point(face.curves[edge.curve], edge.t1), fine.vertices[edge.vertices[1]]), 1e-12);
  }
}

// Triangles without area, and turned over by round-off.
TEST(IntrinsicTriangles, SliversDisappear) {
  SpaceFace face = cylinder_patch();
  const int v = face.boundary_edges[0].vertices[1];
  const Vec3 a = face.vertices[face.boundary_edges[0].vertices[0]],
             b = face.vertices[face.boundary_edges[1].vertices[1]];
  face.vertices[v] = (a + b) / 2;
  expect_delaunay(triangles_of(face));
}

TEST(IntrinsicTriangles, ParametersAreContinuousAcrossTheSeam) {
  const SpaceFace face = face_of(revolved(line({1, 0, 0}, {1, 0, 1})), {{0}, {2}}, 24, 2);
  const IntrinsicTriangles fine = triangles_of(face);
  expect_delaunay(fine);
  for (const IntrinsicTriangle& t : fine.triangles)
    for (int k = 0; k < 3; ++k) {
      EXPECT_LT(std::abs(t.uv[k].x - t.uv[(k + 1) % 3].x), 0.5);
      EXPECT_LT(distance(surface::point(face.surface, t.uv[k]), fine.vertices[t.vertices[k]]), 1e-9);
    }
}

// z^2 = x^3, of x = t^2, z = t^3 for t from -1 to 0.9: the fold at t = 0 lies inside triangles.
TEST(IntrinsicTriangles, RefusesAFold) {
  constexpr double a = -1, b = 0.9;
  NurbsSurface cusp{3, 1, {a, a, a, a, b, b, b, b}, {0, 0, 1, 1}, {}, {}};
  const std::array<std::array<double, 3>, 4> blossoms{{{a, a, a}, {a, a, b}, {a, b, b}, {b, b, b}}};
  for (const auto& [p, q, r] : blossoms)
    for (const double y : {0.0, 1.0}) {
      cusp.poles.push_back({(p * q + q * r + r * p) / 3, y, p * q * r});
      cusp.weights.push_back(1);
    }
  try {
    triangles_of(face_of(cusp, {{0, 1, 2, 3}}, 20, 8));
    ADD_FAILURE() << "is not refused";
  } catch (const ComputeError& e) {
    EXPECT_NE(std::string(e.what()).find("where the surface is folded"), std::string::npos) << e.what();
  }
}

TEST(IntrinsicTriangles, RefusesAnEdgeWithoutLength) {
  SpaceFace face = cylinder_patch();
  face.vertices[face.boundary_edges[0].vertices[1]] = face.vertices[face.boundary_edges[0].vertices[0]];
  try {
    triangles_of(face);
    ADD_FAILURE() << "no refusal";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("edge 0 has no length at (1, 0, 0)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace quadrille::chart
