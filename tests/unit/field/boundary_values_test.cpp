#include "field/boundary_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {
namespace {

CadFace half_disc() {
  CadFace face;
  face.diameter = 2;
  face.curves = {curve::segment({-1, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, pi)};
  face.joints = {{{-1, 0}, -half_pi, 0, half_pi, true}, {{1, 0}, 0, half_pi, half_pi, true}};
  face.loop_offsets = {0, 2};
  return face;
}

TEST(BoundaryValues, StraightSidesOnTheAxesAreExact) {
  const Vec2 value = boundary_value(half_disc(), 0, 0.3);
  EXPECT_EQ(value.x, 1);
  EXPECT_EQ(value.y, 0);
}

TEST(BoundaryValues, FollowTheTangentOfAnArc) {
  const CadFace face = half_disc();
  for (const double t : {0.0, 0.1, 1.0, 2.5, pi}) {
    // The tangent at polar angle t is t + 90 degrees: the same cross.
    const Vec2 value = boundary_value(face, 1, t);
    EXPECT_NEAR(distance(value, unit(4 * angle_of(curve::point(face.curves[1], t)))), 0, 2e-15);
    EXPECT_NEAR(norm(value), 1, 1e-15);
  }
}

TEST(BoundaryValues, SubtractTheLiftingOfAnotherJoint) {
  const CadFace face = half_disc();
  const std::vector<Lifting> liftings{{1, {1, 0}, {2, -1}, {0.5, -2}}};
  const Vec2 x = curve::point(face.curves[0], 1.5);
  const double angle = std::arg(std::complex<double>(x.x - 1, x.y) / std::complex<double>(x.x - 2, x.y + 1));
  const Vec2 value = lifted_boundary_value(face, liftings, 0, 1.5);
  EXPECT_NEAR(value.x, 1 - 0.5 * angle, 1e-15);
  EXPECT_NEAR(value.y, 2 * angle, 1e-15);
}

CadFace polygon(const std::vector<Vec2>& corners) {
  CadFace face;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    face.curves.push_back(curve::segment(corners[i], corners[(i + 1) % corners.size()]));
  }
  return face;
}

TEST(BoundaryValues, ParametersWithinRoundingOfAnEndAreTheEnd) {
  CadFace face = polygon({{0, 0}, {2, 0}, {1.3, 1.1}});
  face.diameter = 2;
  face.loop_offsets = {0, 3};
  const Lifting lifting{1, {2, 0}, {3, -0.5}, {1, 0}};
  const double end = face.curves[0].end();
  EXPECT_NEAR(distance(lifted_boundary_value(face, {lifting}, 0, end * (1 - 1e-13)),
                       lifted_boundary_value(face, {lifting}, 0, end)),
              0, 1e-15);
}

TEST(BoundaryValues, DataOnALineAreNoticed) {
  EXPECT_TRUE(is_line_field(polygon({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}})));               // 45 degree chamfer
  EXPECT_FALSE(is_line_field(polygon({{0, 0}, {1, 0.5}, {0.75, 1}, {0.5, 1}})));               // general angles
  EXPECT_FALSE(is_line_field(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})));                      // one parity: constant
  EXPECT_FALSE(is_line_field(polygon({{0, 0}, {2, 0}, {2, 1}, {1, 2.00001}, {0, 2.00001}})));  // nearly
  EXPECT_FALSE(is_line_field(half_disc()));
}

}  // namespace
}  // namespace quadrille::field
