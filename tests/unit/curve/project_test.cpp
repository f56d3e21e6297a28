#include "curve/project.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

TEST(Project, onto_a_circle_is_radial_from_inside_and_outside) {
  const Nurbs circle = circular_arc({1, 2}, 3, 0, 2 * pi);
  for (int i = 0; i < 24; ++i) {
    const Vec2 direction = unit(0.1 + i * 0.25);
    for (const double r : {0.5, 3.0, 7.0}) {
      const Projection p = project(circle, Vec2{1, 2} + r * direction);
      EXPECT_NEAR(p.distance, std::abs(r - 3), 1e-14);
      EXPECT_NEAR(distance(p.position, Vec2{1, 2} + 3 * direction), 0, 1e-8);
      EXPECT_EQ(p.position, point(circle, p.t));
    }
  }
}

TEST(Project, onto_a_segment_and_its_ends) {
  const Nurbs line = segment({0, 0}, {10, 0});
  EXPECT_NEAR(project(line, {3.3, 2}).t, 3.3, 1e-14);
  EXPECT_EQ(project(line, {-1, 1}).t, 0);
  EXPECT_EQ(project(line, {11, 1}).t, 10);
}

TEST(Project, stays_inside_the_given_interval) {
  const Nurbs circle = circular_arc({0, 0}, 1, 0, 2 * pi);
  const Projection p = project(circle, {2, 0}, 1, 3);
  EXPECT_EQ(p.t, 1);
}

TEST(Project, is_not_misled_by_a_sliver_of_a_span) {
  const Nurbs circle = circular_arc({0, 0}, 1, 0, 2 * pi);
  for (const double sliver : {1e-9, 1e-12, 4.5e-16}) {  // the knot at pi is double
    const Projection p = project(circle, unit(pi + 0.05), pi - sliver, 1.5 * pi);
    EXPECT_NEAR(p.distance, 0, 1e-14) << sliver;
  }
}

TEST(Project, finds_the_nearest_of_two_branches) {
  // A thin hairpin: both branches pass close to the point.
  const Nurbs hairpin =
      cubic_spline({0, 1, 2, 3, 4}, {{0, 0.1}, {1, 0.1}, {1.2, 0}, {1, -0.1}, {0, -0.1}}, {1, 0}, {-1, 0});
  EXPECT_LT(project(hairpin, {0.3, -0.02}).position.y, 0);
  EXPECT_GT(project(hairpin, {0.3, 0.02}).position.y, 0);
}

TEST(Project, finds_the_nearest_of_many_spans) {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int k = 0; k <= 40; ++k) {
    parameters.push_back(k);
    points.push_back({0.1 * k, k % 2 == 0 ? 0.5 : -0.5});
  }
  const Nurbs wave = cubic_spline(parameters, points, {0, 1}, {1, 0});
  std::vector<Vec2> samples;
  for (int k = 0; k <= 40'000; ++k) samples.push_back(point(wave, 1e-3 * k));
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j) {
      const Vec2 x{2 + 0.37 * i, 0.11 * j};
      double least = 10;
      for (const Vec2 sample : samples) least = std::min(least, distance(x, sample));
      const Projection p = project(wave, x);
      EXPECT_LE(p.distance, least + 1e-15) << i << " " << j;
      EXPECT_NEAR(p.distance, least, 5e-4) << i << " " << j;
    }
}

}  // namespace
}  // namespace quadrille::curve
