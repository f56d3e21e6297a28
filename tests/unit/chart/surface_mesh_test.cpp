#include "chart/surface_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

TEST(LiftedMesh, NodesAndNormalsAreThoseOfTheSurface) {
  const SurfaceSample sample(cap());
  const SurfaceMesh mesh = sample.lifted(5);
  ASSERT_EQ(mesh.nodes.size(), static_cast<std::size_t>(mesh.num_elems()) * 21);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    EXPECT_NEAR(norm(mesh.nodes[i]), 1, 1e-12);
    EXPECT_LT(distance(mesh.normals[i], mesh.nodes[i]), 1e-4) << "also at the pole";
    EXPECT_LT(distance(surface::point(sample.face.surface, mesh.uv[i]), mesh.nodes[i]), 1e-10);
  }
  EXPECT_GT(std::ranges::min(least_area_ratios(mesh)), 0.5);
}

/// At Gauss-Lobatto-Legendre fractions of the length.
TEST(LiftedMesh, NodesOfTheBoundaryAreOnTheCurves) {
  const SurfaceSample sample(cylinder_patch());
  const SurfaceMesh mesh = sample.lifted(4);
  for (const BoundaryEdge& edge : mesh.plane.boundary_edges) {
    const SpaceLength& length = sample.lengths[edge.curve];
    const double s0 = length.at(edge.t0), s1 = length.at(edge.t1);
    for (int j = 0; j <= 4; ++j) {
      const double s = s0 + (1 + spectral::gll_points(4)[j]) / 2 * (s1 - s0);
      const Vec3 node = mesh.nodes[mesh.nodes_per_elem() * edge.elem + spectral::tri_edge_node(4, edge.edge, j)];
      EXPECT_LT(distance(node, surface::point(length.curve(), length.parameter(s))), 1e-12);
    }
  }
}

/// Neighbours have the same nodes on a common edge, across the seam too.
TEST(LiftedMesh, IsContinuous) {
  const SurfaceSample sample(tube());
  const SurfaceMesh mesh = sample.lifted(3);
  double worst = 0;
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k) {
      const auto ends = [&](int elem, int edge) {
        const auto& v = mesh.plane.elem2vertices[elem];
        return std::pair(v[edge], v[(edge + 1) % 3]);
      };
      const auto [a, b] = ends(e, k);
      for (int other = e + 1; other < mesh.num_elems(); ++other)
        for (int j = 0; j < 3; ++j) {
          if (ends(other, j) != std::pair(b, a)) continue;
          for (int i = 0; i <= 3; ++i)
            worst = std::max(worst, distance(mesh.nodes[10 * e + spectral::tri_edge_node(3, k, i)],
                                             mesh.nodes[10 * other + spectral::tri_edge_node(3, j, 3 - i)]));
        }
    }
  EXPECT_LT(worst, 1e-12);
}

TEST(LeastAreaRatios, AreOneOfStraightTrianglesAndNegativeWhereTheyTurnOver) {
  SurfaceMesh mesh;
  mesh.order = 2;
  mesh.plane.vertices = {{0, 0}, {1, 0}, {0, 1}};
  mesh.plane.elem2vertices = {{0, 1, 2}};
  for (const Vec2 xi : spectral::tri_nodes(2)) mesh.nodes.push_back({(1 + xi.x) / 2, (1 + xi.y) / 2, 0});
  mesh.normals.assign(6, {0, 0, 1});
  EXPECT_NEAR(least_area_ratios(mesh).at(0), 1, 1e-14);
  mesh.normals.assign(6, {0, 0, -1});
  EXPECT_NEAR(least_area_ratios(mesh).at(0), -1, 1e-14);
  mesh.normals.assign(6, {0, 0, 1});
  mesh.nodes[3] = {0.5, 0.6, 0};  // the middle of the lower edge
  EXPECT_LT(least_area_ratios(mesh).at(0), 0);
  mesh.nodes[3].x = NAN;
  EXPECT_EQ(least_area_ratios(mesh).at(0), -std::numeric_limits<double>::infinity());
}

/// x^2 along the lower edge of the unit triangle, by the part of its length.
TEST(ImageSlope, IsTheDerivativeByThePartOfTheEdge) {
  SurfaceMesh mesh;
  mesh.order = 2;
  mesh.plane.elem2vertices = {{0, 1, 2}};
  for (const Vec2 xi : spectral::tri_nodes(2)) {
    const double x = (1 + xi.x) / 2;
    mesh.image.push_back({x * x, 3 * x});
  }
  EXPECT_LT(distance(image_slope(mesh, {0, 0, 0, 0, 1}, false), {0, 3}), 1e-13);
  EXPECT_LT(distance(image_slope(mesh, {0, 0, 0, 0, 1}, true), {2, 3}), 1e-13);
  EXPECT_LT(distance(image_slope(mesh, {0, 2, 0, 0, 1}, false), {0, 0}), 1e-13) << "from the top, where x is 0";
}

TEST(FaceNormal, IsThatOfTheFace) {
  SpaceFace face = cap();
  const Vec2 uv{1, 1};
  const Vec3 normal = face_normal(face, uv);
  EXPECT_LT(distance(normal, surface::point(face.surface, uv)), 1e-12);
  face.is_reversed = true;
  EXPECT_LT(distance(face_normal(face, uv), -normal), 1e-15);
}

TEST(CornerParameters, AtAPoleTheParameterAlongTheSideDoesNotCount) {
  const SpaceFace face = cap();
  const double pole = face.surface.knots_v.back();
  EXPECT_EQ(face_normal(face, {1, pole}), (Vec3{}));
  const CornerParameters at_pole = corner_parameters(face, {1, pole}), elsewhere = corner_parameters(face, {1, 1});
  EXPECT_TRUE(!at_pole.has_u && at_pole.has_v);
  EXPECT_TRUE(elsewhere.has_u && elsewhere.has_v);
}

}  // namespace
}  // namespace quadrille::chart
