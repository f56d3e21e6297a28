#include "curve/least_squares_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::curve {

namespace {

template <class Function>
std::vector<FitPoint> sampled(Function position, double length, int count) {
  std::vector<FitPoint> points;
  for (int i = 0; i <= count; ++i) points.push_back({length * i / count, position(length * i / count)});
  return points;
}

FitEnds ends_of(const Nurbs& curve) {
  return {point(curve, curve.begin()), derivative(curve, curve.begin()), point(curve, curve.end()),
          derivative(curve, curve.end(), true)};
}

TEST(LeastSquaresSpline, ReproducesASplineOnItsKnots) {
  const Nurbs curve{5,
                    {0, 0, 0, 0, 0, 0, 0.5, 1.25, 1.25, 2, 2, 2, 2, 2, 2},
                    {{0, 0}, {0.1, 0.3}, {0.4, 0.2}, {0.7, 0.9}, {1, 0}, {1.2, 0.2}, {1.5, -0.3}, {1.7, 0.1}, {2, 0}},
                    std::vector<double>(9, 1.0)};
  const auto fit = least_squares_spline(5, {{0}, {0.5}, {1.25, 2}, {2}},
                                        sampled([&](double t) { return point(curve, t); }, 2, 60), ends_of(curve));
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->knots, curve.knots);
  for (std::size_t i = 0; i < curve.poles.size(); ++i) EXPECT_LT(distance(fit->poles[i], curve.poles[i]), 1e-12) << i;
}

TEST(LeastSquaresSpline, InSpaceFollowsAHelixAndATiltedCircle) {
  const auto helix = [](double t) { return Vec3{std::cos(t), std::sin(t), 0.3 * t}; };
  const auto circle = [](double t) { return Vec3{std::cos(t), std::sin(t), 0.3 * std::cos(t)}; };
  std::vector<FitKnot> knots;
  for (int i = 0; i <= 16; ++i) knots.push_back({2 * pi * i / 16});
  std::vector<SpaceFitPoint> of_helix, of_circle;
  for (int i = 0; i <= 200; ++i) {
    const double t = 2 * pi * i / 200;
    of_helix.push_back({t, helix(t)}), of_circle.push_back({t, circle(t)});
  }
  const auto open = least_squares_spline(7, knots, of_helix, SpaceFitEnds{{0, 1, 0.3}, {0, 1, 0.3}});
  const auto closed = least_squares_spline(7, knots, of_circle, std::nullopt);
  ASSERT_TRUE(open && closed);
  EXPECT_EQ(closed->poles.front(), closed->poles.back());
  for (int i = 0; i < 100; ++i) {
    const double t = 2 * pi * (i + 0.37) / 100;
    EXPECT_LT(distance(surface::point(*open, t), helix(t)), 1e-8);
    EXPECT_LT(distance(surface::point(*closed, t), circle(t)), 1e-8);
  }
}

TEST(LeastSquaresSpline, KeepsEndsAndTheirDerivativesWhateverThePoints) {
  const FitEnds ends{{0, 0}, {1, 2}, {3, 1}, {0, -1}};
  const auto fit = least_squares_spline(7, {{0}, {1}, {1.5}, {4}},
                                        sampled(
                                            [](double t) {
                                              return Vec2{t, std::sin(5 * t)};
                                            },
                                            4, 200),
                                        ends);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->poles.front(), ends.start);
  EXPECT_EQ(fit->poles.back(), ends.end);
  EXPECT_LT(distance(derivative(*fit, 0), ends.start_derivative), 1e-13);
  EXPECT_LT(distance(derivative(*fit, 4, true), ends.end_derivative), 1e-13);
}

TEST(LeastSquaresSpline, WeightsPointsAndRefusesTooFew) {
  // Two points at the same parameter, the second of them three times as heavy: their mean is nearer to it.
  std::vector<FitPoint> points = sampled([](double t) { return Vec2{t, 0}; }, 1, 20);
  points.insert(points.begin() + 11, {points[10].parameter, {0.5, 4e-3}, 3});
  const FitEnds ends{{0, 0}, {1, 0}, {1, 0}, {1, 0}};
  const auto light = least_squares_spline(7, {{0}, {1}}, sampled([](double t) { return Vec2{t, 0}; }, 1, 20), ends);
  const auto heavy = least_squares_spline(7, {{0}, {1}}, points, ends);
  ASSERT_TRUE(light && heavy);
  EXPECT_NEAR(point(*light, 0.5).y, 0, 1e-14);
  EXPECT_GT(point(*heavy, 0.5).y, 5e-4);
  EXPECT_FALSE(least_squares_spline(7, {{0}, {0.25}, {0.5}, {1}}, {{0.1, {0, 0}}, {0.9, {1, 0}}}, ends));
}

TEST(LeastSquaresSpline, AClosedCurveHasNoSeam) {
  std::vector<FitKnot> knots;
  for (int i = 0; i <= 12; ++i) knots.push_back({2 * pi * i / 12});
  const auto fit = periodic_least_squares_spline(7, knots, sampled([](double t) { return unit(t); }, 2 * pi, 600));
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->poles.front(), fit->poles.back());
  EXPECT_EQ(fit->knots.size(), 8 + 11 + 8U);
  for (int i = 0; i < 500; ++i) EXPECT_LT(distance(point(*fit, 2 * pi * i / 500), unit(2 * pi * i / 500)), 1e-8);
  const auto before = derivatives(*fit, fit->end(), true), after = derivatives(*fit, fit->begin());
  for (int n = 0; n < 4; ++n) EXPECT_LT(distance(before[n], after[n]), 1e-11) << n;
}

TEST(LeastSquaresSpline, AClosedCurveMayBendAtItsSeam) {
  // Two parabolas that meet with a common tangent at the seam, and without one in the middle, where the knot has
  // multiplicity 7.
  const auto lens = [](double t) { return t < 1 ? Vec2{t * t, t} : Vec2{(2 - t) * (2 - t), (2 - t) * (3 - 2 * t)}; };
  const auto fit = periodic_least_squares_spline(7, {{0, 6}, {1, 7}, {2, 6}}, sampled(lens, 2, 200));
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->knots.size(), 8 + 7 + 8U);
  for (const double t : {0.0, 0.3, 0.9, 1.1, 1.7}) EXPECT_LT(distance(point(*fit, t), lens(t)), 1e-10) << t;
}

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
