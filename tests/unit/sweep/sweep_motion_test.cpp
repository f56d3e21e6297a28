#include "sweep/sweep_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "sweep_samples.hpp"

namespace quadrille::sweep {
namespace {

void expect_near(Vec3 x, Vec3 expected, double tolerance = 1e-14) {
  EXPECT_LE(distance(x, expected), tolerance) << x.x << ' ' << x.y << ' ' << x.z;
}

TEST(SweepMotion, TheSecondOfTwoMotionsFollowsTheFirst) {
  SpaceMotion shift;
  shift.shift = {1, 0, 0};
  const SpaceMotion quarter = rotation({{0, 0, 0}, {0, 0, 1}}, half_pi);
  expect_near(image(combined(shift, quarter), {1, 0, 0}), {0, 2, 0});
  expect_near(image(combined(quarter, shift), {1, 0, 0}), {1, 1, 0});
}

TEST(SweepMotion, PointsOfAnAxisStay) {
  const SpaceMotion turned = rotation({{1, 2, 3}, {0, 1, 0}}, 0.7);
  expect_near(image(turned, {1, 5, 3}), {1, 5, 3});
  expect_near(image(rotation({{1, 0, 0}, {0, 0, 1}}, half_pi), {2, 0, 4}), {1, 1, 4});
}

TEST(SweepMotion, BeginsWithTheFaceItself) {
  SweepShape shape = straight({0, 0, 2});
  shape.twist = 1, shape.taper = 0.5;
  expect_near(image(SweepMotion(shape).at(0), {0.3, 0.4, 0.5}), {0.3, 0.4, 0.5}, 0);
}

/// Half of the way: half of the twist, and the mean of both sizes.
TEST(SweepMotion, TwistAndTaperGrowEvenlyAboutTheCentre) {
  SweepShape shape = straight({0, 0, 2});
  shape.twist = pi, shape.taper = 0.5;
  const SweepMotion motion(shape);
  expect_near(image(motion.at(0.5), {1.5, 0.5, 0}), {0.5, 0.5 + 0.75, 1});
  expect_near(image(motion.at(1), {1.5, 0.5, 0}), {0, 0.5, 2});
  EXPECT_FALSE(motion.is_rigid() || motion.is_steady() || motion.is_straight());
  EXPECT_EQ(motion.length(), 2);
}

TEST(SweepMotion, KindsAreTold) {
  EXPECT_TRUE(SweepMotion(straight({0, 0, 1})).is_straight());
  SweepShape twisted = straight({0, 0, 1});
  twisted.twist = 1;
  EXPECT_TRUE(SweepMotion(twisted).is_steady());
  EXPECT_FALSE(SweepMotion(twisted).is_straight());
  const auto is_closed = [](double angle) { return SweepMotion(revolved(angle, {-1, 0, 0}, {0, 1, 0})).is_closed(); };
  EXPECT_TRUE(is_closed(2 * pi) && is_closed(-2 * pi));
  EXPECT_FALSE(is_closed(2 * pi - 1e-9) || is_closed(pi) || is_closed(4 * pi));
  SweepShape spiral = revolved(2 * pi, {-1, 0, 0}, {0, 1, 0});
  spiral.twist = 2 * pi;
  EXPECT_FALSE(SweepMotion(spiral).is_closed());
}

/// Points at equal angles of a circle of radius 4, seen from y: a plane curve does not turn about its tangent.
SweepShape quarter_circle() {
  SweepShape shape = straight({});
  for (int k = 0; k <= 40; ++k) {
    const double t = half_pi * k / 40;
    shape.curve.push_back({4 - 4 * std::cos(t), 0.5, 4 * std::sin(t)});
  }
  return shape;
}

TEST(SweepMotion, AlongAPlaneCurveTheFaceTurnsWithTheTangent) {
  const SweepMotion motion(quarter_circle());
  EXPECT_NEAR(motion.length(), 2 * pi, 1e-5);
  EXPECT_TRUE(motion.is_rigid());
  EXPECT_FALSE(motion.is_steady());
  const SpaceMotion middle = motion.at(0.5);
  const double s = std::sqrt(0.5);
  expect_near(image(middle, {0, 0.5, 0}), {4 - 4 * s, 0.5, 4 * s}, 1e-5);
  expect_near(image(middle, {1, 1.5, 0}) - image(middle, {0, 0.5, 0}), {s, 1, -s}, 2e-5);  // of a spline
}

TEST(SweepMotion, AlongALineItIsATranslation) {
  SweepShape shape = straight({});
  shape.curve = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  const SweepMotion motion(shape);
  EXPECT_NEAR(motion.length(), 3 * std::sqrt(3), 1e-12);
  expect_near(image(motion.at(1), {0.2, 0.7, 0}), {3.2, 3.7, 3}, 1e-13);
}

/// A helix with as much rise as arc: parallel transport turns back by the integral of the torsion, sin(45 degrees) of
/// the turn.
TEST(SweepMotion, AlongAHelixTheFrameTurnsBackByItsTorsion) {
  SweepShape shape = straight({});
  for (int k = 0; k <= 400; ++k) {
    const double t = 2 * pi * k / 400;
    shape.curve.push_back({std::cos(t), std::sin(t), t});
  }
  const SpaceMotion turn = SweepMotion(shape).at(1);
  const Vec3 inward{-1, 0, 0}, carried = image(turn, inward) - image(turn, {});
  EXPECT_NEAR(carried.x, -std::cos(2 * pi * std::sqrt(0.5)), 1e-5);
}

TEST(SweepMotion, ACurveCarriesTheFaceWithoutTurningItAboutTheTangent) {
  const HexMesh mesh = swept(quads(3), quarter_circle(), {0, 0.25, 0.5, 0.75, 1});
  expect_proved(mesh);
  // As a revolution about x = 4, z = 0.
  const std::size_t count = quads(3).nodes.size(), top = mesh.nodes.size() - count;
  for (std::size_t q = 0; q < count; ++q) {
    const Vec3 from = mesh.nodes[q], to = mesh.nodes[top + q];
    EXPECT_NEAR(to.x, 4, 5e-5);
    EXPECT_NEAR(to.y, from.y, 5e-5);
    EXPECT_NEAR(to.z, 4 - from.x, 5e-5);
  }
}

}  // namespace
}  // namespace quadrille::sweep
