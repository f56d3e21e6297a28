#include "trace/launch_directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::trace {
namespace {

double off_cross(const Mat2& j, double alpha) { return wrap_pi(4 * alpha - angle_of(j * unit(alpha))); }

TEST(LaunchDirections, ThreeRaysAtZ) {
  const auto rays = launch_directions({1, 0, 0, 1});
  ASSERT_EQ(rays.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(wrap_pi(rays[k] - 2 * pi * k / 3), 0, 1e-15);
}

TEST(LaunchDirections, FiveRaysAtConjugateZ) {
  const auto rays = launch_directions({1, 0, 0, -1});
  ASSERT_EQ(rays.size(), 5u);
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(wrap_pi(rays[k] - 2 * pi * k / 5), 0, 1e-15);
}

TEST(LaunchDirections, TurnWithTheFrame) {
  // Turning the plane by beta turns v by 4 beta: J' = R(4 beta) J R(-beta).
  const Mat2 j{1.3, 0.2, -0.4, 0.7};
  const double beta = 0.37;
  const auto r = [](double a) { return Mat2{std::cos(a), -std::sin(a), std::sin(a), std::cos(a)}; };
  const auto rays = launch_directions(j), turned = launch_directions(r(4 * beta) * j * r(-beta));
  ASSERT_EQ(rays.size(), turned.size());
  for (const double ray : rays) {
    double nearest = 10;
    for (const double other : turned) nearest = std::min(nearest, std::abs(wrap_pi(other - ray - beta)));
    EXPECT_LT(nearest, 1e-14);
  }
}

TEST(LaunchDirections, AFanLaunchesItsMiddleOnly) {
  // Five directions satisfy 4 alpha = arg(J e(alpha)) here; three of them share one k.
  const Mat2 j{718, 0, 0, 1};
  const auto rays = launch_directions(j);
  ASSERT_EQ(rays.size(), 3u);
  for (const double ray : rays) EXPECT_NEAR(off_cross(j, ray), 0, 1e-9);
  for (size_t a = 0; a < 3; ++a)
    for (size_t b = a + 1; b < 3; ++b) EXPECT_GT(std::abs(wrap_pi(rays[a] - rays[b])), 0.5);
  // The mirror image y -> -y of this field is itself, and so are its rays.
  EXPECT_NEAR(wrap_pi(rays[0]), 0, 1e-12);
  EXPECT_NEAR(wrap_pi(rays[1] + rays[2]), 0, 1e-9);
}

TEST(CornerLaunch, DividesMultiplesOfRightAnglesEvenly) {
  EXPECT_TRUE(corner_launch_directions(half_pi, 1).empty());
  const auto reflex = corner_launch_directions(3 * half_pi, 3);
  ASSERT_EQ(reflex.size(), 2u);
  EXPECT_NEAR(reflex[0], half_pi, 1e-15);
  EXPECT_NEAR(reflex[1], pi, 1e-15);
  const auto slit = corner_launch_directions(2 * pi * 0.999999999, 4);
  ASSERT_EQ(slit.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(slit[k], (k + 1) * half_pi, 1e-7);
}

TEST(CornerLaunch, SolvesTheChordAndIsSymmetricAboutTheBisector) {
  const double omega = radians(258);
  const auto rays = corner_launch_directions(omega, 3);
  ASSERT_EQ(rays.size(), 2u);
  EXPECT_NEAR(rays[0] + rays[1], omega, 1e-12);
  for (const double ray : rays) {
    const Vec2 a{1, 0}, b = unit(4 * omega), v = a + (ray / omega) * (b - a);
    EXPECT_NEAR(wrap_pi(4 * ray - angle_of(v)), 0, 1e-12);
  }
}

TEST(CornerLaunch, TakesTheBisectorAtATieAndInItsFan) {
  EXPECT_NEAR(corner_launch_directions(radians(135), 2).at(0), radians(67.5), 1e-8);
  EXPECT_NEAR(corner_launch_directions(radians(223), 2).at(0), radians(111.5), 1e-12);
}

TEST(PhaseLaunch, LinesStartAtEqualAnglesAlongTheCross) {
  for (const int valence : {3, 5, 6, 8}) {
    const double phi_0 = 0.7;
    const std::vector<double> rays = phase_launch_directions(phi_0, valence);
    ASSERT_EQ(static_cast<int>(rays.size()), valence);
    for (int k = 0; k < valence; ++k) {
      EXPECT_NEAR(rays[k] - rays[0], 2 * pi * k / valence, 1e-14);
      EXPECT_NEAR(wrap_pi(4 * rays[k] - phi_0 - (4 - valence) * rays[k]), 0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace quadrille::trace
