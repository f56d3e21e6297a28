#include "curve/arc_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

// Half axes 3 and 1: an affine image of the unit circle's NURBS.
Nurbs ellipse() {
  Nurbs e = circular_arc({0, 0}, 1, 0, 2 * pi);
  for (Vec2& pole : e.poles) pole.x *= 3;
  return e;
}

TEST(ArcLength, of_a_segment_is_its_length) {
  const Nurbs line = segment({1, 1}, {4, 5});
  const ArcLength length(line);
  EXPECT_EQ(length.total(), 5);
  EXPECT_EQ(length.at(1.25), 1.25);
  EXPECT_EQ(length.parameter(1.25), 1.25);
}

TEST(ArcLength, of_a_circle_is_exact_to_round_off) {
  const Nurbs circle = circular_arc({0, 0}, 2, 0.4, 0.4 + 2 * pi);
  const ArcLength length(circle);
  EXPECT_NEAR(length.total(), 4 * pi, 4 * pi * 1e-14);
  for (int i = 0; i <= 36; ++i) {
    const double t = length.parameter(4 * pi * i / 36.0);
    const Vec2 exact = 2 * unit(0.4 + 2 * pi * i / 36);
    EXPECT_NEAR(distance(point(circle, t), exact), 0, 3e-14);
  }
}

TEST(ArcLength, of_a_part_of_a_circle_whose_weights_are_unequal_is_exact_to_round_off) {
  const Nurbs circle = circular_arc({20, -30}, 2, 0, half_pi);
  const Nurbs part = trimmed(circle, 0.1 * circle.end(), 0.7 * circle.end());
  const double swept = angle_of(part.poles.back() - Vec2{20, -30}) - angle_of(part.poles.front() - Vec2{20, -30});
  const ArcLength length(part);
  EXPECT_NEAR(length.total(), 2 * swept, 1e-14);
  for (int i = 1; i < 20; ++i) {
    const Vec2 x = point(part, length.parameter(length.total() * i / 20)) - part.poles.front();
    EXPECT_NEAR(norm(x), 4 * std::sin(swept * i / 40), 2e-14);
  }
}

TEST(ArcLength, of_an_ellipse_is_the_complete_elliptic_integral) {
  const Nurbs curve = ellipse();
  // 4 a E(m), m = 8/9; std::comp_ellint_2 itself is 2e-14 off here.
  EXPECT_NEAR(ArcLength(curve).total(), 13.364893220555258, 14 * 1e-14);
}

TEST(ArcLength, parameter_inverts_at) {
  const Nurbs curve = ellipse();
  const ArcLength length(curve);
  for (int i = 1; i < 50; ++i) {
    const double s = length.total() * i / 50;
    EXPECT_NEAR(length.at(length.parameter(s)), s, 14 * 1e-14);
  }
  EXPECT_EQ(length.parameter(-1), curve.begin());
  EXPECT_EQ(length.parameter(1e9), curve.end());
}

TEST(ArcLength, is_symmetric_on_a_symmetric_curve) {
  const Nurbs curve = circular_arc({0, 0}, 1, pi, 0);
  const ArcLength length(curve);
  for (int i = 1; i < 20; ++i) {
    const double s = length.total() * i / 40;
    const Vec2 a = point(curve, length.parameter(s)), b = point(curve, length.parameter(length.total() - s));
    EXPECT_NEAR(a.x, -b.x, 3e-15);
    EXPECT_NEAR(a.y, b.y, 3e-15);
  }
}

TEST(ArcLength, handles_a_vanishing_speed) {
  // C = (t^2, t^3), length ((4 + 9)^1.5 - 8) / 27.
  const Nurbs curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}}, {1, 1, 1, 1}};
  EXPECT_NEAR(ArcLength(curve).total(), (std::pow(13, 1.5) - 8) / 27, 3e-14);
}

TEST(ArcLength, of_a_curve_tiny_beside_its_coordinates_ends_where_rounding_begins) {
  const Vec2 far{30, 20};
  std::vector<double> at;
  std::vector<Vec2> points;
  for (int i = 0; i <= 8; ++i) {
    at.push_back(1e-6 * i / 8);
    points.push_back(far + 1e-6 * unit(i / 8.0));
  }
  const Nurbs curve = cubic_spline(at, points, left_of(unit(0)), left_of(unit(1)));
  EXPECT_NEAR(ArcLength(curve).total(), 1e-6, 1e-11);  // an arc of one radian
}

// y = x^2 on [-1, 2] as a cubic spline of uneven spans, which reproduces it; length of the part to x is exact.
TEST(ArcLength, of_a_parabola_of_many_spans_is_exact_to_round_off) {
  const std::vector<double> x{-1, -0.9, -0.2, 0.5, 0.6, 1.7, 2};
  std::vector<Vec2> points;
  for (const double t : x) points.push_back({t, t * t});
  const Nurbs parabola = cubic_spline(x, points, {1, -2}, {1, 4});
  const ArcLength length(parabola);
  const auto primitive = [](double t) { return (2 * t * std::sqrt(1 + 4 * t * t) + std::asinh(2 * t)) / 4; };
  for (const double t : {-0.95, -0.9, 0.0, 0.3, 1.699, 2.0}) {
    EXPECT_NEAR(length.at(t), primitive(t) - primitive(-1), 1e-14 * length.total());
    EXPECT_NEAR(length.parameter(primitive(t) - primitive(-1)), t, 1e-14);
  }
}

// The speed of a thin ellipse is that of a function with singularities next to the curve.
TEST(ArcLength, of_a_thin_ellipse_is_its_elliptic_integral) {
  // E(1 - b^2) by the arithmetic-geometric mean with 40 digits; std::comp_ellint_2 is up to 3e-13 off.
  constexpr std::pair<double, double> integrals[] = {
      {0.1, 1.0159935450252239}, {0.05, 1.0048564047864904}, {0.01, 1.0002745824306630}, {0.001, 1.0000038970261721}};
  for (const auto& [b, integral] : integrals) {
    const Nurbs quarter{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, b}, {0, b}}, {1, std::sqrt(0.5), 1}};
    const ArcLength length(quarter);
    EXPECT_NEAR(length.total(), integral, 1e-13) << b;
    for (const double t : {0.02, 0.3, 0.5, 0.7, 0.98})
      EXPECT_NEAR(length.at(t), ArcLength(trimmed(quarter, 0, t)).total(), 1e-13) << b << " " << t;
  }
}

}  // namespace
}  // namespace quadrille::curve
