#include "curve/simplify_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::curve {

namespace {

using Position = std::function<Vec2(double)>;

Vec2 slope_of(const Position& position, double t) {
  const double h = 1e-4;
  return (8 * (position(t + h) - position(t - h)) - (position(t + 2 * h) - position(t - 2 * h))) / (12 * h);
}

/// The cubic spline through `count` + 1 points of a curve at parameters 0 to 1.
Nurbs through(const Position& position, int count) {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) parameters.push_back(1.0 * i / count), points.push_back(position(parameters.back()));
  return cubic_spline(parameters, points, slope_of(position, 0), slope_of(position, 1));
}

Vec2 wave(double t) { return {t, 0.1 * std::sin(6 * t)}; }

/// The ellipse once around; the last point is the first one, bit for bit.
Nurbs ellipse_through(int count) {
  const auto position = [](double t) { return Vec2{2 * std::cos(2 * pi * t), std::sin(2 * pi * t)}; };
  Nurbs curve = through(position, count);
  curve.poles.back() = curve.poles.front();
  return curve;
}

double farthest(const Nurbs& a, const Nurbs& b) {
  double greatest = 0;
  for (int i = 0; i <= 60; ++i) {
    const double t = a.begin() + (a.end() - a.begin()) * i / 60;
    greatest = std::max(greatest, project(b, point(a, t)).distance);
  }
  return greatest;
}

TEST(SimplifySpline, ASmoothCurveThroughManyPointsNeedsFewKnotsAndNoBreaks) {
  const Nurbs curve = through(wave, 2000);
  const auto fit = simplified_spline(curve, 1e-8);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->knots_before, 1999);
  EXPECT_LE(fit->knots_after, 40);
  EXPECT_EQ(smoothness_breaks(fit->curve).size(), 0U);
  EXPECT_LE(fit->distance, 1e-8);
  EXPECT_LE(farthest(curve, fit->curve), fit->distance * 1.01 + 1e-14);
  EXPECT_LE(farthest(fit->curve, curve), fit->distance * 1.01 + 1e-14);
}

TEST(SimplifySpline, EndsAndTangentsStay) {
  const Nurbs curve = through(wave, 500);
  const auto fit = simplified_spline(curve, 1e-6);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->curve.poles.front(), curve.poles.front());
  EXPECT_EQ(fit->curve.poles.back(), curve.poles.back());
  EXPECT_LT(distance(tangent(fit->curve, fit->curve.begin()), tangent(curve, 0)), 1e-14);
  EXPECT_LT(distance(tangent(fit->curve, fit->curve.end(), true), tangent(curve, 1, true)), 1e-14);
}

TEST(SimplifySpline, ACoarserToleranceNeedsFewerKnots) {
  const Nurbs curve = through(wave, 2000);
  EXPECT_LT(simplified_spline(curve, 1e-5)->knots_after, simplified_spline(curve, 1e-9)->knots_after);
}

TEST(SimplifySpline, NoiseBelowTheToleranceDoesNotMatter) {
  const auto noisy = [](double t) {
    const int i = static_cast<int>(std::lround(1000 * t));
    return wave(t) + 1e-9 * Vec2{std::sin(37.0 * i * i), std::cos(53.0 * i * i)};
  };
  const auto fit = simplified_spline(through(noisy, 1000), 1e-8);
  ASSERT_TRUE(fit);
  EXPECT_LE(fit->knots_after, 40);
}

TEST(SimplifySpline, CurvesWithFewBreaksOrWithManyThatAreNeededStay) {
  EXPECT_FALSE(simplified_spline(through(wave, 30), 1e-6));
  EXPECT_FALSE(simplified_spline(circular_arc({0, 0}, 1, 0, 2 * pi), 1e-6));
  const auto rough = [](double t) {
    const int i = static_cast<int>(std::lround(1000 * t));
    return wave(t) + 1e-4 * Vec2{std::sin(37.0 * i * i), std::cos(53.0 * i * i)};
  };
  EXPECT_FALSE(simplified_spline(through(rough, 1000), 1e-8));
}

TEST(SimplifySpline, AJumpOfTheCurvatureStays) {
  // A line, then an arc of radius 1, with 400 spans each; the knot between them is double, the others are simple.
  const auto line = [](double t) { return Vec2{t - 1, 0}; };
  const auto arc = [](double t) { return Vec2{std::sin(t), 1 - std::cos(t)}; };
  Nurbs curve = through(line, 400);
  const Nurbs tail = through(arc, 400);
  curve.knots.resize(curve.knots.size() - 1);
  for (std::size_t i = 4; i < tail.knots.size(); ++i) curve.knots.push_back(tail.knots[i] + 1);
  for (std::size_t i = 1; i < tail.poles.size(); ++i) curve.poles.push_back(tail.poles[i]), curve.weights.push_back(1);
  ASSERT_EQ(curve.knots.size(), curve.poles.size() + 4);
  const auto fit = simplified_spline(curve, 1e-8);
  ASSERT_TRUE(fit);
  const std::vector<double> breaks = smoothness_breaks(fit->curve);
  ASSERT_EQ(breaks.size(), 1U);
  EXPECT_LT(distance(point(fit->curve, breaks[0]), {0, 0}), 1e-8);
  EXPECT_LT(distance(tangent(fit->curve, breaks[0], true), tangent(fit->curve, breaks[0])), 1e-9);
  EXPECT_NEAR(curvature(fit->curve, breaks[0], true), 0, 1e-4);
  EXPECT_NEAR(curvature(fit->curve, breaks[0]), 1, 1e-4);
}

TEST(SimplifySpline, AClosedCurveHasNoBreakAtItsSeam) {
  const auto fit = simplified_spline(ellipse_through(3000), 1e-8);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->curve.poles.front(), fit->curve.poles.back());
  EXPECT_TRUE(has_smooth_seam(fit->curve));
  EXPECT_TRUE(smoothness_breaks(fit->curve).empty());
  EXPECT_LT(distance(fit->curve.poles.front(), {2, 0}), 1e-8);
}

TEST(SimplifySpline, TheReversedCurveHasTheReversedFit) {
  const auto uneven = [](double t) { return Vec2{t + 0.2 * t * t, 0.2 * std::exp(-20 * (t - 0.3) * (t - 0.3))}; };
  const Nurbs curve = through(uneven, 777);
  const auto fit = simplified_spline(curve, 1e-8), back = simplified_spline(reversed(curve), 1e-8);
  ASSERT_TRUE(fit && back);
  const Nurbs forth = reversed(back->curve);
  ASSERT_EQ(forth.poles.size(), fit->curve.poles.size());
  for (std::size_t i = 0; i < forth.poles.size(); ++i)
    EXPECT_LT(distance(forth.poles[i], fit->curve.poles[i]), 1e-12) << i;
}

TEST(SimplifySpline, AMirrorSymmetricCurveHasAMirrorSymmetricFit) {
  // Even and odd numbers of spans: a knot at the middle, or two beside it.
  for (const int count : {1000, 1001}) {
    const Nurbs curve = through([](double t) { return Vec2{t - 0.5, std::exp(-30 * (t - 0.5) * (t - 0.5))}; }, count);
    const auto fit = simplified_spline(curve, 1e-8);
    ASSERT_TRUE(fit);
    const std::vector<Vec2>& poles = fit->curve.poles;
    for (std::size_t i = 0; i < poles.size(); ++i) {
      const Vec2 image = poles[poles.size() - 1 - i];
      EXPECT_LT(distance(poles[i], {-image.x, image.y}), 1e-12) << count << " " << i;
    }
  }
}

TEST(FitCells, ALongSpanIsCutAndLastingJumpsAreIsolated) {
  const Nurbs circle = circular_arc({0, 0}, 1, 0, 2 * pi);
  const FitCells cells = fit_cells(circle);
  EXPECT_GE(cells.cells.size(), 24U);
  EXPECT_EQ(cells.nodes.size(), cells.cells.size() + 1);
  EXPECT_NEAR(cells.nodes.back().length, 2 * pi, 1e-12);
  std::vector<FitNode> nodes;
  for (int i = 0; i <= 100; ++i) nodes.push_back({i / 100.0, i / 100.0, 1e-6, 0});
  EXPECT_TRUE(lasting_jumps(nodes, 2, 1e-8).empty());
  nodes[40].curvature_jump = 1;
  EXPECT_EQ(lasting_jumps(nodes, 2, 1e-8), std::vector<int>{40});
  EXPECT_TRUE(lasting_jumps(nodes, 2, 1e-2).empty());
  EXPECT_TRUE(lasting_jumps(nodes, 3, 1e-8).empty());
}

}  // namespace

}  // namespace quadrille::curve
