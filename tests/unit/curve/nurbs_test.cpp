#include "curve/nurbs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"

namespace quadrille::curve {
namespace {

void expect_near(Vec2 a, Vec2 b, double tol) {
  EXPECT_NEAR(a.x, b.x, tol);
  EXPECT_NEAR(a.y, b.y, tol);
}

// The cubic (t^3 - t, 2 t^2 + 1) with its derivatives.
std::array<Vec2, 4> cubic(double t) {
  return {Vec2{t * t * t - t, 2 * t * t + 1}, Vec2{3 * t * t - 1, 4 * t}, Vec2{6 * t, 4}, Vec2{6, 0}};
}

Nurbs splined_cubic() {
  const std::vector<double> t{-1, -0.3, 0.2, 0.25, 1.5, 2};
  std::vector<Vec2> points;
  for (const double s : t) points.push_back(cubic(s)[0]);
  return cubic_spline(t, points, cubic(-1)[1], cubic(2)[1]);
}

// Two quarter-circle-like pieces whose curvature jumps: a line that runs into a unit arc, as one curve.
Nurbs line_into_arc() {
  Nurbs curve = circular_arc({0, 1}, 1, -half_pi, 0);
  // Degree 2 line from (-1, 0) to (0, 0) before it, joined by a double knot.
  curve.poles.insert(curve.poles.begin(), {Vec2{-1, 0}, Vec2{-0.5, 0}});
  curve.weights.insert(curve.weights.begin(), {1, 1});
  curve.knots = {-1, -1, -1, 0, 0, half_pi, half_pi, half_pi};
  return curve;
}

TEST(Nurbs, a_circular_arc_lies_on_its_circle_and_knows_its_curvature) {
  const Nurbs arc = circular_arc({3, -2}, 2.5, 0.3, 0.3 + 2 * pi);
  EXPECT_EQ(arc.poles.size(), 9U);
  for (int i = 0; i <= 40; ++i) {
    const double t = 2 * pi * i / 40;
    EXPECT_NEAR(distance(point(arc, t), {3, -2}), 2.5, 4e-15);
    EXPECT_NEAR(curvature(arc, t), 0.4, 1e-13);
    EXPECT_NEAR(dot(tangent(arc, t), point(arc, t) - Vec2{3, -2}), 0, 1e-14);
  }
  expect_near(point(arc, half_pi), Vec2{3, -2} + 2.5 * unit(0.3 + half_pi), 1e-15);
}

TEST(Nurbs, a_clockwise_arc_bends_to_the_right) {
  const Nurbs arc = circular_arc({0, 0}, 1, half_pi, -half_pi);
  EXPECT_NEAR(curvature(arc, 1), -1, 1e-13);
  expect_near(tangent(arc, 0), {1, 0}, 1e-15);
  expect_near(point(arc, arc.end()), {0, -1}, 1e-15);
}

TEST(Nurbs, point_and_derivative_are_those_that_are_computed_alone) {
  for (const Nurbs& curve : {circular_arc({3, -2}, 2.5, 0.3, 4), line_into_arc(), segment({0, 1}, {2, 5})})
    for (int i = 0; i <= 20; ++i) {
      const double t = curve.begin() + (curve.end() - curve.begin()) * i / 20;
      const PointAndDerivative both = point_and_derivative(curve, t);
      expect_near(both.point, point(curve, t), 1e-15 * 10);
      EXPECT_EQ(both.derivative, derivative(curve, t));
    }
  const Nurbs arc = circular_arc({0, 0}, 1, 0.1, 1.3);
  EXPECT_EQ(point_and_derivative(arc, arc.begin()).point, arc.poles.front());
  EXPECT_EQ(point_and_derivative(arc, arc.end() + 1).point, arc.poles.back());
}

TEST(Nurbs, ends_are_the_end_poles_bit_for_bit_whatever_the_weights) {
  Nurbs curve = circular_arc({0, 0}, 1, 0.1, 1.3);
  for (double& w : curve.weights) w *= 0.3;
  EXPECT_EQ(point(curve, curve.begin()), curve.poles.front());
  EXPECT_EQ(point(curve, curve.end()), curve.poles.back());
  EXPECT_EQ(derivatives(curve, curve.end())[0], curve.poles.back());
  EXPECT_EQ(point(curve, -7), curve.poles.front());
}

TEST(Nurbs, the_clamped_spline_reproduces_a_cubic_with_all_derivatives) {
  const Nurbs spline = splined_cubic();
  for (double t = -1; t <= 2; t += 0.0625) {
    const auto exact = cubic(t), d = derivatives(spline, t), left = derivatives(spline, t, true);
    for (int n = 0; n < 4; ++n) {
      expect_near(d[n], exact[n], 2e-12 * std::pow(10, n));
      expect_near(left[n], exact[n], 2e-12 * std::pow(10, n));
    }
  }
}

TEST(Nurbs, a_spline_through_two_points_is_the_hermite_cubic) {
  const Nurbs spline = cubic_spline({0, 2}, {cubic(0)[0], cubic(2)[0]}, cubic(0)[1], cubic(2)[1]);
  expect_near(point(spline, 1.25), cubic(1.25)[0], 1e-14);
}

TEST(Nurbs, reversing_walks_the_same_curve_backwards) {
  const Nurbs spline = splined_cubic(), back = reversed(spline);
  EXPECT_EQ(back.begin(), spline.begin());
  EXPECT_EQ(back.end(), spline.end());
  for (double t = -1; t <= 2; t += 0.125) {
    expect_near(point(back, 1 - t), point(spline, t), 1e-14);
    expect_near(tangent(back, 1 - t, true), -tangent(spline, t), 1e-13);
  }
}

TEST(Nurbs, trimming_keeps_parameters_and_points) {
  const Nurbs arc = circular_arc({0, 0}, 1, 0, 2 * pi);
  for (const auto& [a, b] : {std::pair{0.2, 0.9}, {0.2, 4.0}, {half_pi, pi}, {0.0, 3.0}, {3.0, 2 * pi}}) {
    const Nurbs part = trimmed(arc, a, b);
    ASSERT_EQ(part.knots.size(), part.poles.size() + 3);
    EXPECT_EQ(part.begin(), a);
    EXPECT_EQ(part.end(), b);
    for (int i = 0; i <= 16; ++i) {
      const double t = a + (b - a) * i / 16;
      expect_near(point(part, t), point(arc, t), 1e-14);
    }
  }
  EXPECT_EQ(trimmed(arc, 0.2, 0.9).poles.size(), 3U);
  EXPECT_EQ(trimmed(arc, 0.2, 0.9).poles.front(), point(arc, 0.2));
}

TEST(Nurbs, trimming_beside_a_knot_and_again_keeps_the_poles) {
  const double beside = 0.5 + 2e-12;
  const Nurbs spline{3,
                     {0, 0, 0, 0, 0.25, beside, 0.75, 1, 1, 1, 1},
                     {{0, 0}, {0.1, 0.2}, {0.3, 0.3}, {0.5, 0.2}, {0.7, 0.3}, {0.9, 0.2}, {1, 0}},
                     {1, 1, 1, 1, 1, 1, 1}};
  const Nurbs once = trimmed(spline, 0.5, 1), twice = trimmed(once, 0.5, 0.875), direct = trimmed(spline, 0.5, 0.875);
  ASSERT_EQ(twice.poles.size(), direct.poles.size());
  for (std::size_t i = 0; i < twice.poles.size(); ++i) expect_near(twice.poles[i], direct.poles[i], 1e-14);
}

TEST(Nurbs, the_tangent_at_a_vanishing_derivative_is_its_limit) {
  // C = (t^2, t^3): a cusp at 0.
  const Nurbs curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}}, {1, 1, 1, 1}};
  expect_near(tangent(curve, 0), {1, 0}, 1e-15);
  expect_near(tangent(reversed(curve), 1, true), {-1, 0}, 1e-15);
}

TEST(Nurbs, a_full_circle_has_no_break_though_its_knots_are_double) {
  EXPECT_TRUE(smoothness_breaks(circular_arc({5, 5}, 0.01, 0, 2 * pi)).empty());
  EXPECT_TRUE(smoothness_breaks(segment({0, 0}, {3, 4})).empty());
  EXPECT_TRUE(smoothness_breaks(splined_cubic()).empty());
}

TEST(Nurbs, a_curvature_jump_is_a_break) {
  const auto breaks = smoothness_breaks(line_into_arc());
  ASSERT_EQ(breaks.size(), 1U);
  EXPECT_EQ(breaks[0], 0);
}

TEST(Nurbs, a_jump_of_the_third_derivative_is_a_break) {
  const Nurbs spline = cubic_spline({0, 1, 2, 3}, {{0, 0}, {1, 0.3}, {2, -0.2}, {3, 0.1}}, {1, 0}, {1, 0});
  EXPECT_EQ(smoothness_breaks(spline), (std::vector<double>{1, 2}));
}

TEST(MoveEnds, ASegmentStaysASegmentWithItsLengthAsParameter) {
  const Nurbs moved = with_ends(segment({0, 0}, {3, 0}), {0, 0}, {3, 4});
  EXPECT_EQ(moved.degree, 1);
  EXPECT_DOUBLE_EQ(moved.end(), 5);
}

TEST(MoveEnds, EqualDisplacementsMoveTheCurveAndNothingElse) {
  const Nurbs arc = circular_arc({1, 2}, 3, 0.1, 1.4);
  const Vec2 way = {0.01, -0.02};
  const Nurbs moved = with_ends(arc, arc.poles.front() + way, arc.poles.back() + way);
  for (const double t : {0.0, 0.3, 0.8, 1.0}) {
    const double u = arc.begin() + t * (arc.end() - arc.begin());
    EXPECT_NEAR(distance(point(moved, u), point(arc, u) + way), 0, 1e-14);
  }
}

TEST(MoveEnds, PolesThatCoincideRemainSoAndTangentsTurnByTheDisplacementOverTheLength) {
  const Nurbs curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {1, 0}, {2, 0}}, {1, 1, 1, 1}};
  const Nurbs moved = with_ends(curve, {0, 1e-4}, {2, 0});
  EXPECT_EQ(moved.poles[0], (Vec2{0, 1e-4}));
  EXPECT_EQ(moved.poles[1], moved.poles[0]);
  EXPECT_EQ(moved.poles[3], (Vec2{2, 0}));
  EXPECT_NEAR(angle_of(tangent(moved, moved.begin())), -1e-4 / 2, 1e-8);
}

TEST(MoveEnds, AClosedCurveMovesAsAWhole) {
  const Nurbs circle = circular_arc({0, 0}, 1, 0, 2 * pi);
  const Vec2 seam = {1, 1e-3};
  const Nurbs moved = with_ends(circle, seam, seam);
  EXPECT_EQ(moved.poles.front(), seam);
  EXPECT_EQ(moved.poles.back(), seam);
  EXPECT_NEAR(point(moved, (moved.begin() + moved.end()) / 2).x, -1, 1e-12);
}

TEST(Nurbs, PointsOfAnArcAndAtADoubleKnot) {
  const Nurbs arc{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}};
  for (const double t : {0.0, 0.25, 0.5, 0.9, 1.0}) EXPECT_NEAR(norm(point(arc, t)), 1, 1e-15);
  EXPECT_EQ(point(arc, 0), (Vec2{1, 0}));
  EXPECT_EQ(point(arc, 1), (Vec2{0, 1}));
  const Nurbs kinked{2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, {1, 1, 1, 1, 1}};
  EXPECT_EQ(point(kinked, 1), (Vec2{2, 0})) << "the pole at the double knot";
  EXPECT_EQ(point(kinked, 2), (Vec2{2, 2}));
}

}  // namespace
}  // namespace quadrille::curve
