#include "sweep/space_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::sweep {
namespace {

double cubic(double t) { return 1 - 2 * t + 3 * t * t - t * t * t; }
double cubic_slope(double t) { return -2 + 6 * t - 3 * t * t; }

TEST(SplineSlopes, OfACubicAreThoseOfTheCubic) {
  const std::vector<double> knots{0, 0.3, 1, 1.2, 2.5};
  std::vector<Vec3> points;
  for (const double t : knots) points.push_back({cubic(t), -2 * cubic(t), t});
  const std::vector<Vec3> slopes = spline_slopes(points, knots);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    EXPECT_NEAR(slopes[k].x, cubic_slope(knots[k]), 1e-12) << k;
    EXPECT_NEAR(slopes[k].y, -2 * cubic_slope(knots[k]), 1e-12) << k;
    EXPECT_NEAR(slopes[k].z, 1, 1e-12) << k;
  }
}

TEST(SplineSlopes, OfThreePointsAreThoseOfAParabolaOfTwoThoseOfALine) {
  const std::vector<Vec3> parabola = spline_slopes({{0, 0, 0}, {1, 0, 0}, {9, 0, 0}}, {0, 1, 3});
  EXPECT_NEAR(parabola[0].x, 0, 1e-13);
  EXPECT_NEAR(parabola[1].x, 2, 1e-13);
  EXPECT_NEAR(parabola[2].x, 6, 1e-13);
  for (const Vec3 slope : spline_slopes({{1, 0, 0}, {5, 0, 0}}, {0, 2})) EXPECT_NEAR(slope.x, 2, 1e-15);
}

TEST(SpaceSpline, PassesThroughItsPointsWithoutKinks) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 2}};
  const SpaceSpline spline(points);
  ASSERT_EQ(spline.num_spans(), 3);
  EXPECT_EQ(spline.knot(0), 0);
  EXPECT_EQ(spline.knot(1), 0.25) << "a quarter of the chords";
  EXPECT_EQ(spline.knot(3), 1);
  for (int k = 0; k <= 3; ++k) EXPECT_LT(norm(spline.at(spline.knot(k)) - points[k]), 1e-14) << k;
  constexpr double h = 1e-7;
  for (const double u : {0.25, 0.5}) {
    EXPECT_LT(norm(spline.derivative(u - h) - spline.derivative(u + h)), 1e-4) << u;
    EXPECT_LT(norm((spline.at(u + h) - spline.at(u - h)) / (2 * h) - spline.derivative(u)), 1e-5) << u;
  }
}

}  // namespace
}  // namespace quadrille::sweep
