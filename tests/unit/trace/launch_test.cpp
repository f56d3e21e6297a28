#include "trace/launch.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "base/error.hpp"

namespace quadrille::trace {
namespace {

TEST(LaunchLine, FollowsACurvedSeparatrixToThirdOrder) {
  // v = z (1 + c z): the separatrix along the axis bends away with c's imaginary part.
  const auto value = [](Vec2 p) {
    const Vec2 c{0, 0.3}, w{1 + c.x * p.x - c.y * p.y, c.x * p.y + c.y * p.x};
    return Vec2{p.x * w.x - p.y * w.y, p.x * w.y + p.y * w.x};
  };
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 2, value);
  const field::FieldEvaluator evaluator(field);
  // Near 0 the separatrix is y = kappa x^2 / 2 with 4 y' = y / x + 0.3 x, so kappa = 0.3 / 3.5.
  const double kappa = 0.3 / 3.5;
  for (const double r : {1e-2, 1e-3}) {
    const Launch launch = launch_line(evaluator, 0, {0, 0}, 0, r, 1);
    EXPECT_NEAR(launch.x.y, kappa * r * r / 2, r * r * r);
    EXPECT_NEAR(launch.angle_there, kappa * r, r * r);
    EXPECT_NEAR(norm(launch.x), r, 1e-14);
  }
}

TEST(LaunchLine, RefusesADirectionOutOfTheDomain) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator evaluator(field);
  EXPECT_THROW(launch_line(evaluator, 0, {0, 0}, -1, 1e-3, 1), ComputeError);
}

}  // namespace
}  // namespace quadrille::trace
