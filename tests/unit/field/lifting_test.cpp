#include "field/lifting.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"

namespace quadrille::field {
namespace {

// The apex at the origin, the pole straight below it: the domain above.
Lifting lifting() {
  Lifting l;
  l.apex = {0, 0};
  l.pole = {0, -1};
  return l;
}

TEST(Lifting, AngleIsTheOneUnderWhichTheApexAndThePoleAreSeen) {
  EXPECT_NEAR(lifting_angle(lifting(), {0, 5}), 0, 1e-15);
  EXPECT_NEAR(lifting_angle(lifting(), {1, 0}), -pi / 4, 1e-15);
  EXPECT_NEAR(lifting_angle(lifting(), {-1, 0}), pi / 4, 1e-15);
  EXPECT_NEAR(lifting_angle(lifting(), {-0.5, -0.5}), half_pi, 1e-15);
}

TEST(Lifting, GradientIsTheSlopeOfTheAngle) {
  const double h = 1e-6;
  for (const Vec2 x : {Vec2{0.7, 0.3}, Vec2{-2, 1}, Vec2{0.1, 0.05}}) {
    const auto slope = [&](Vec2 step) {
      return (lifting_angle(lifting(), x + step) - lifting_angle(lifting(), x - step)) / (2 * h);
    };
    const Vec2 gradient = lifting_gradient(lifting(), x);
    EXPECT_NEAR(gradient.x, slope({h, 0}), 1e-8);
    EXPECT_NEAR(gradient.y, slope({0, h}), 1e-8);
  }
}

TEST(Lifting, AngleAtTheApexIsTheLimitAlongADirection) {
  for (const double angle : {0.1, 1.0, 2.0, 3.0})
    EXPECT_NEAR(lifting_angle_at_apex(lifting(), unit(angle)), lifting_angle(lifting(), 1e-10 * unit(angle)), 1e-9);
  EXPECT_NEAR(lifting_angle_at_apex(lifting(), {1, 0}), -half_pi, 1e-15);
}

}  // namespace
}  // namespace quadrille::field
