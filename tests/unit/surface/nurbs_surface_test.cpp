#include "surface/nurbs_surface.hpp"

#include <gtest/gtest.h>

#include "../curved_surfaces.hpp"

namespace quadrille {
namespace {

using tests::profile_arc;

double height_off_torus(Vec3 x, double major, double minor) {
  return std::hypot(std::hypot(x.x, x.y) - major, x.z) - minor;
}

TEST(NurbsSurface, PointsLieOnTheirSurfaces) {
  for (double u : {0.0, 0.3, 2.0, 6.2})
    for (double f : {0.0, 0.1, 0.77, 1.0}) {
      const NurbsSurface ball = tests::sphere(2), ring = tests::torus(3, 1);
      EXPECT_NEAR(norm(surface::point(ball, {u, (f - 0.5) * std::numbers::pi})), 2, 1e-14);
      EXPECT_NEAR(height_off_torus(surface::point(ring, {u, f * 2 * std::numbers::pi}), 3, 1), 0, 1e-14);
    }
  const Vec3 apex = surface::point(tests::cone(1, 2), {0.4, 0});
  EXPECT_EQ(norm(apex), 0);
}

TEST(NurbsSurface, DerivativesAreThoseOfDifferences) {
  const NurbsSurface s = tests::torus(3, 1);
  const double h = 1e-4;
  const Vec2 uv{0.9, 2.3};
  const auto at = [&](double a, double b) { return surface::point(s, {uv.x + a * h, uv.y + b * h}); };
  const surface::SurfacePoint p = surface::evaluate(s, uv);
  EXPECT_LT(norm(p.xu - (at(1, 0) - at(-1, 0)) / (2 * h)), 1e-7);
  EXPECT_LT(norm(p.xv - (at(0, 1) - at(0, -1)) / (2 * h)), 1e-7);
  EXPECT_LT(norm(p.xuu - (at(1, 0) - 2 * at(0, 0) + at(-1, 0)) / (h * h)), 1e-6);
  EXPECT_LT(norm(p.xvv - (at(0, 1) - 2 * at(0, 0) + at(0, -1)) / (h * h)), 1e-6);
  EXPECT_LT(norm(p.xuv - (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h)), 1e-6);
}

TEST(NurbsSurface, TheGreatestCurvatureIsThatOfTheSharperBend) {
  EXPECT_NEAR(surface::greatest_curvature(tests::cylinder(2, 1), {0.7, 0.4}), 0.5, 1e-12);
  EXPECT_NEAR(surface::greatest_curvature(tests::torus(3, 0.5), {0.7, 0.4}), 2, 1e-12);
  EXPECT_NEAR(surface::greatest_curvature(tests::torus(1, 0.8), {0.7, std::numbers::pi}), 5, 1e-10)
      << "around the hole";
  EXPECT_EQ(surface::greatest_curvature(tests::cone(1, 1), {0.7, 0}), 0) << "at the tip";
}

TEST(NurbsSurface, ParametersOfClosedSurfacesAreBroughtBack) {
  const NurbsSurface s = tests::cylinder(1, 2);
  const double turn = 2 * std::numbers::pi;
  EXPECT_LT(norm(surface::point(s, {0.5 + turn, 1}) - surface::point(s, {0.5, 1})), 1e-14);
  EXPECT_LT(norm(surface::point(s, {0.5 - turn, 7}) - surface::point(s, {0.5, 1})), 1e-14);
}

TEST(NurbsSurface, NearestPointsAreFoundAcrossTheSeam) {
  const NurbsSurface s = tests::cylinder(2, 2);
  const auto found = surface::project(s, {2.5 * std::cos(-0.2), 2.5 * std::sin(-0.2), 0.7}, {0.1, 0.5});
  EXPECT_TRUE(found.is_converged);
  EXPECT_NEAR(found.distance, 0.5, 1e-13);
  EXPECT_LT(norm(found.position - Vec3{2 * std::cos(-0.2), 2 * std::sin(-0.2), 0.7}), 1e-13);
  EXPECT_GT(found.uv.x, 6);
}

TEST(NurbsSurface, NearestPointsAreFoundFromAGuessAtAPole) {
  const NurbsSurface s = tests::sphere(1);
  for (const double u : {0.0, 1.0, 4.0, 5.1}) {
    const Vec3 x = normalized(Vec3{-0.02, 0.05, 1});
    const double from_pole = u > 5 ? 3e-8 : 0;
    const auto found = surface::project(s, 1.01 * x, {u, std::numbers::pi / 2 - from_pole});
    EXPECT_TRUE(found.is_converged);
    EXPECT_LT(norm(found.position - x), 1e-13);
  }
}

TEST(NurbsSurface, NearestPointsAreFoundOnTheOtherSideOfAPole) {
  const NurbsSurface s = tests::sphere(1);
  for (int i = 0; i < 500; ++i) {
    const double far = std::pow(10, -(i % 10) * 0.4 - 0.5), near = far * (0.05 + 0.05 * (i % 13)), a = i * 0.7;
    const Vec3 x = normalized(Vec3{far * std::cos(a), far * std::sin(a), 1});
    const Vec2 guess{std::fmod(i * 1.3, 6.28), std::numbers::pi / 2 - near};
    EXPECT_LT(norm(surface::project(s, 0.97 * x, guess).position - x), 1e-9);
  }
}

TEST(NurbsSurface, NearestPointsAreFoundNearAPoleAndAtIt) {
  const NurbsSurface s = tests::sphere(1);
  for (const double off : {0.0, 1e-9, 1e-5, 1e-2}) {
    const Vec3 x = 1.1 * normalized(Vec3{-off, off, 1});
    const auto found = surface::project(s, x, {0.3, 1.4});
    EXPECT_LT(norm(found.position - x / 1.1), 2e-9) << off;  // beyond the pole, the azimuth is only known so well
    EXPECT_NEAR(found.distance, 0.1, 1e-12);
  }
}

TEST(SpaceCurve, DerivativesAndReversal) {
  const SpaceCurve arc = profile_arc(0, 2, 0, 3);
  const auto d = surface::derivatives(arc, 1.2);
  EXPECT_NEAR(norm(d[0]), 2, 1e-14);
  EXPECT_NEAR(dot(d[0], d[1]), 0, 1e-13);
  const double h = 1e-4;
  const Vec3 second = (surface::point(arc, 1.2 + h) - 2 * d[0] + surface::point(arc, 1.2 - h)) / (h * h);
  EXPECT_LT(norm(d[2] - second), 1e-6);
  EXPECT_LT(norm(surface::point(surface::reversed(arc), 1.2) - surface::point(arc, 3 - 1.2)), 1e-14);
  EXPECT_EQ(surface::point(arc, 0), arc.poles.front());
}

}  // namespace
}  // namespace quadrille
