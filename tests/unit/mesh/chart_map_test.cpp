#include "mesh/chart_map.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../curved_surfaces.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::mesh {
namespace {

const std::vector<Vec2> points{{0.1, 0.2}, {0.25, 0.25}, {0.5, 0.5}, {0, 0}, {0.01, 0.499}, {0.37, 0.123}};

TEST(ChartMap, LiftedPointsAreOnTheExactSurface) {
  const CadFace face = samples::sphere_face(2, 10);
  const ChartMap map(face);
  for (const Vec2 x : points) {
    EXPECT_NEAR(norm(map.lift(x)), 1, 1e-15);
    EXPECT_NEAR(distance(map.lift(x), samples::on_sphere(x)), 0, 1e-9);
    EXPECT_NEAR(map.log_scale(x), samples::sphere_log_scale(x), 1e-9);
    Vec2 gradient;
    EXPECT_EQ(map.log_scale(x, gradient), map.log_scale(x));
    EXPECT_NEAR(distance(gradient, -2 / (1 + norm2(x)) * x), 0, 1e-7);
    EXPECT_NEAR(distance(map.normal(x), samples::on_sphere(x)), 0, 1e-7);
    std::optional<Vec2> uv;
    EXPECT_NEAR(map.distance_from_surface(1.0001 * samples::on_sphere(x), x, uv), 1e-4, 1e-14);
    EXPECT_NEAR(distance(*uv, x), 0, 1e-8);
    EXPECT_NEAR(map.distance_from_surface(0.9999 * samples::on_sphere(x), x, uv), 1e-4, 1e-14);
  }
}

TEST(ChartMap, CurvedTrianglesAreLiftedLikewise) {
  const CadFace face = samples::cap_face();
  const ChartMap map(face);
  for (const Vec2 x : {Vec2{0.1, 0.2}, {-0.7, 0.3}, {0.56, 0.56}, {0, 0.79}, {-0.79, 0.01}}) {
    EXPECT_NEAR(norm(map.lift(x)), 1, 1e-15);
    EXPECT_NEAR(distance(map.lift(x), samples::on_sphere(x)), 0, 1e-7);
    EXPECT_NEAR(map.log_scale(x), samples::sphere_log_scale(x), 1e-7);
  }
}

TEST(ChartMap, PointsJustOutsideAreInTheNearestTriangle) {
  const CadFace face = samples::sphere_face(2, 10);
  const ChartMap map(face);
  const Vec2 x{0.3, -1e-7};
  EXPECT_NEAR(map.log_scale(x), samples::sphere_log_scale(x), 1e-8);
  EXPECT_NEAR(distance(map.lift(x), samples::on_sphere(Vec2{0.3, 0})), 0, 1e-6);
  EXPECT_GE(map.locate({-7, 9}).elem, 0);
}

TEST(ChartMap, BoundaryPointsAreThoseOfTheCurvesInSpace) {
  const CadFace face = samples::sphere_face();
  const ChartMap map(face);
  EXPECT_EQ(map.boundary_point(1, 0), face.chart->space_curves[1].poles.front());
  EXPECT_NEAR(distance(map.boundary_point(1, 0.3), samples::on_sphere(Vec2{0.5, 0.15})), 0, 1e-15);
}

TEST(ChartMap, PolesOfTheParametrisationAreNoObstacle) {
  CadFace face = samples::sphere_face(2, 8);
  Chart chart = *face.chart;
  chart.surfaces = {tests::sphere(1)};  // its pole is at the corner (0, 0) of the chart
  for (std::size_t i = 0; i < chart.uv.size(); ++i) {
    const Vec2 x = chart.nodes[i];
    const Vec2 guess{norm(x) > 0 ? angle_of(x) : 0.0, M_PI / 2 - 2 * std::atan(norm(x))};
    chart.uv[i] = norm(x) > 0 ? surface::project(chart.surfaces[0], chart.space_nodes[i], guess).uv : guess;
  }
  face.chart = std::make_shared<const Chart>(chart);
  const ChartMap map(face);
  for (const Vec2 x : points) {
    EXPECT_NEAR(norm(map.lift(x)), 1, 1e-14);
    EXPECT_NEAR(distance(map.lift(x), samples::on_sphere(x)), 0, 1e-7);
  }
  EXPECT_NEAR(distance(map.lift({1e-4, 1e-5}), samples::on_sphere(Vec2{1e-4, 1e-5})), 0, 1e-7);
}

TEST(ChartMap, SamplesHavePositionScaleAndDerivatives) {
  const CadFace face = samples::sphere_face(2, 10);
  const ChartMap map(face);
  const Vec2 x{0.21, 0.34};
  EXPECT_LE(distance(map.sample(x).position, samples::on_sphere(x)), 1e-8);
  EXPECT_NEAR(map.sample(x).log_scale, samples::sphere_log_scale(x), 1e-8);
  EXPECT_NEAR(map.greatest_curvature(x), 1, 1e-6);
  const auto [by_x, by_y] = map.derivatives(x);
  const double scale = std::exp(samples::sphere_log_scale(x)), step = 1e-5;
  EXPECT_NEAR(norm(by_x), scale, 1e-6);
  EXPECT_NEAR(dot(by_x, by_y), 0, 1e-6);
  EXPECT_LE(norm(by_x - (samples::on_sphere(x + Vec2{step, 0}) - samples::on_sphere(x - Vec2{step, 0})) / (2 * step)),
            1e-6);
  EXPECT_NEAR(map.greatest_gradient(), std::sqrt(0.5), 1e-6) << "r in space, in the corner";
}

TEST(ChartMap, TheNearestPointOfAPositionInSpaceIsInsideOrOnTheBoundary) {
  const CadFace face = samples::sphere_face(3, 10);
  const ChartMap map(face);
  for (const Vec2 x : {Vec2{0.21, 0.34}, {0.01, 0.49}, {0.25, 0.25}, {0, 0.3}, {0.5, 0.5}}) {
    const ChartMap::Foot foot = map.nearest(1.02 * samples::on_sphere(x));
    EXPECT_LE(distance(foot.x, x), 1e-7);
    EXPECT_NEAR(foot.distance, 0.02, 1e-8);
  }
  const ChartMap::Foot outside = map.nearest(samples::on_sphere({-0.1, 0.2}));
  EXPECT_NEAR(outside.x.x, 0, 1e-9);
  EXPECT_GT(outside.distance, 0.19 / 1.05);
}

TEST(ChartMap, ItsTrianglesAreAMesh) {
  const TriMesh mesh = chart_triangles(samples::sphere_face(2, 3));
  EXPECT_EQ(mesh.vertices.size(), 9u);
  EXPECT_EQ(mesh.elem2vertices.size(), 8u);
  for (int e = 0; e < 8; ++e)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(mesh.vertices[mesh.elem2vertices[e][k]], mesh.curved_nodes[e * 10 + k]);
}

}  // namespace
}  // namespace quadrille::mesh
