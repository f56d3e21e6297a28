#include "field/boundary_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille {
namespace {

CadFace half_disc() {
  CadFace face;
  face.diameter = 2;
  face.curves = {segment({-1, 0}, {1, 0}), circular_arc({0, 0}, 1, 0, pi)};
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
    EXPECT_NEAR(distance(value, unit(4 * angle_of(point(face.curves[1], t)))), 0, 2e-15);
    EXPECT_NEAR(norm(value), 1, 1e-15);
  }
}

TEST(BoundaryValues, SubtractTheLiftingOfAnotherJoint) {
  const CadFace face = half_disc();
  const std::vector<Lifting> liftings{{1, {1, 0}, {2, -1}, {0.5, -2}}};
  const Vec2 x = point(face.curves[0], 1.5);
  const double angle = std::arg(std::complex<double>(x.x - 1, x.y) / std::complex<double>(x.x - 2, x.y + 1));
  const Vec2 value = lifted_boundary_value(face, liftings, 0, 1.5);
  EXPECT_NEAR(value.x, 1 - 0.5 * angle, 1e-15);
  EXPECT_NEAR(value.y, 2 * angle, 1e-15);
}

}  // namespace
}  // namespace quadrille
