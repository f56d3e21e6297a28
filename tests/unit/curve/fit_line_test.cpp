#include "curve/fit_line.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

const CurveFunction circle = [](double s, Vec2& d) {
  d = left_of(unit(s));
  return unit(s);
};

TEST(FitLine, FollowsACircleWithinTheTolerance) {
  for (const double tol : {1e-6, 1e-9}) {
    const Nurbs spline = fit_line(circle, 2 * pi, tol);
    for (int i = 0; i <= 1000; ++i) {
      const double s = 2 * pi * i / 1000;
      EXPECT_LT(distance(point(spline, s), unit(s)), 1.5 * tol);
    }
  }
}

TEST(FitLine, KeepsEndsAndEndDirections) {
  const Nurbs spline = fit_line(circle, 1.3, 1e-8);
  EXPECT_EQ(point(spline, 0), unit(0));
  EXPECT_EQ(point(spline, 1.3), unit(1.3));
  EXPECT_LT(distance(tangent(spline, 0), left_of(unit(0))), 1e-14);
  EXPECT_LT(distance(tangent(spline, 1.3, true), left_of(unit(1.3))), 1e-14);
}

TEST(FitLine, EvaluatesTheCurveOnceAtEachParameter) {
  std::map<double, int> counts;
  const CurveFunction counted = [&](double s, Vec2& d) {
    ++counts[s];
    return circle(s, d);
  };
  EXPECT_GT(fit_line(counted, 2 * pi, 1e-9).poles.size(), 50u);
  for (const auto& [s, count] : counts) EXPECT_LE(count, s == 0 || s == 2 * pi ? 2 : 1) << s;  // ends: derivative too
}

TEST(FitLine, RefinesOnlyWhereTheCurveNeedsIt) {
  // Straight but for a bump at its middle.
  const CurveFunction bump = [](double s, Vec2& d) {
    const double z = (s - 0.5) / 0.02, y = 0.01 * std::exp(-z * z);
    d = {1, -2 * z / 0.02 * y};
    return Vec2{s, y};
  };
  const Nurbs spline = fit_line(bump, 1, 1e-8);
  int near = 0, far = 0;
  for (const double t : spline.knots) (std::abs(t - 0.5) < 0.15 ? near : far) += 1;
  EXPECT_GT(near, 2 * far);
}

}  // namespace
}  // namespace quadrille::curve
