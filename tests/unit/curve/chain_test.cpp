#include "curve/chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "curve/gauss.hpp"
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

/// A polynomial curve of two spans whose weights are all 2.
Nurbs two_spans(int degree) {
  Nurbs curve{degree, {}, {}, {}};
  for (int i = 0; i <= degree + 1; ++i) {
    curve.poles.push_back({1.0 * i, std::sin(2.0 * i)});
    curve.weights.push_back(2);
  }
  curve.knots.assign(degree + 1, 0);
  curve.knots.push_back(0.7);
  curve.knots.insert(curve.knots.end(), degree + 1, 2);
  return curve;
}

TEST(ArcLength, of_polynomial_curves_of_any_degree_is_that_of_their_derivatives) {
  for (int degree = 2; degree <= 10; ++degree) {
    const Nurbs curve = two_spans(degree);
    const ArcLength length(curve);
    double sum = 0;
    for (const auto& [a, b] : {std::pair{0.0, 0.7}, std::pair{0.7, 2.0}})
      for (int k = 0; k < 64; ++k) {
        const double low = a + (b - a) * k / 64, high = a + (b - a) * (k + 1) / 64;
        sum += gauss_integral([&](double t) { return norm(derivative(curve, t)); }, low, high);
        EXPECT_NEAR(length.at(high), sum, 1e-13 * sum) << degree;
        EXPECT_NEAR(length.parameter(sum), high, 1e-12) << degree;
      }
    EXPECT_NEAR(length.total(), sum, 1e-13 * sum) << degree;
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

// A slot's side: a unit line into a quarter arc of radius 1, then a spline that is no CAD curve.
struct ChainTest : testing::Test {
  ChainTest() {
    face.curves = {segment({-1, 0}, {0, 0}), circular_arc({0, 1}, 1, -half_pi, 0)};
    splines = {cubic_spline({0, 1, 2}, {{1, 1}, {1.2, 2}, {1, 3}}, {0, 1}, {0, 1})};
  }
  CadFace face;
  std::vector<Nurbs> splines;
};

TEST_F(ChainTest, runs_through_its_pieces_by_length) {
  const CurveTable table(face, splines);
  const Chain chain(table, {{0, 0, 1}, {1, 0, half_pi}});
  EXPECT_NEAR(chain.length(), 1 + half_pi, 1e-14);
  EXPECT_EQ(chain.at(0).position, (Vec2{-1, 0}));
  EXPECT_EQ(chain.at(1).position, face.curves[1].poles.back());
  const ChainPoint middle = chain.at((1 + pi / 4) / chain.length());
  EXPECT_EQ(middle.piece, 1);
  EXPECT_NEAR(distance(middle.position, Vec2{0, 1} + unit(-pi / 4)), 0, 1e-14);
  EXPECT_NEAR(distance(middle.tangent, unit(pi / 4)), 0, 1e-14);
}

TEST_F(ChainTest, walked_backwards_gives_the_same_points) {
  const CurveTable table(face, splines);
  const Chain there(table, {{0, 0, 1}, {1, 0, half_pi}}), back(table, {{1, half_pi, 0}, {0, 1, 0}});
  for (int i = 0; i <= 20; ++i) {
    const ChainPoint a = there.at(i / 20.0), b = back.at(1 - i / 20.0);
    EXPECT_NEAR(distance(a.position, b.position), 0, 1e-14);
    EXPECT_NEAR(distance(a.tangent, -b.tangent), 0, 1e-13);
    EXPECT_EQ(there.position(i / 20.0), a.position);
    EXPECT_EQ(back.position(1 - i / 20.0), b.position);
  }
}

TEST_F(ChainTest, breaks_are_joints_and_breaks_of_cad_curves_but_not_of_splines) {
  // The spline has a break at its middle when taken for a CAD curve.
  const CurveTable table(face, splines);
  const Chain mixed(table, {{1, 0, half_pi}, {2, 0, 2}});
  EXPECT_EQ(mixed.break_fractions(), mixed.joint_fractions());
  ASSERT_EQ(mixed.joint_fractions().size(), 1U);
  EXPECT_NEAR(mixed.joint_fractions()[0] * mixed.length(), half_pi, 1e-13);

  CadFace with_spline = face;
  with_spline.curves.push_back(splines[0]);
  const std::vector<Nurbs> none;
  const CurveTable cad(with_spline, none);
  const Chain chain(cad, {{2, 2, 0}});
  ASSERT_EQ(chain.break_fractions().size(), 1U);
  EXPECT_NEAR(chain.break_fractions()[0], 0.5, 1e-13);
}

TEST_F(ChainTest, breaks_next_to_an_end_count_as_that_end) {
  CadFace drawn = face;
  drawn.diameter = 2;
  const int first = drawn.num_curves();
  drawn.curves.push_back(segment({0, 0}, {1, 0}));
  drawn.curves.push_back(segment({1, 0}, {1, 1}));
  drawn.curves.push_back(segment({1, 1}, {1, 1 + 1e-6}));
  const CurveTable table(drawn, splines);
  const auto breaks = [&](double of_first, double of_second) {
    return Chain(table, {{first, 1 - of_first, 1}, {first + 1, 0, of_second}}).break_fractions().size();
  };
  EXPECT_EQ(breaks(1.9e-6, 1), 0U);
  EXPECT_EQ(breaks(2.1e-6, 1), 1U);
  EXPECT_EQ(breaks(1, 1e-9), 0U);
  EXPECT_EQ(breaks(1e-7, 1e-7), 1U) << "a short chain keeps its inner breaks";
  // A whole curve that is so short may have a name.
  EXPECT_EQ(Chain(table, {{first + 1, 0, 1}, {first + 2, 0, 1e-6}}).break_fractions().size(), 1U);
  EXPECT_EQ(Chain(table, {{first + 2, 1e-6, 0}, {first + 1, 1, 0}}).break_fractions().size(), 1U);
}

TEST_F(ChainTest, the_seam_of_a_circle_is_no_break_but_that_of_a_drop_is) {
  CadFace closed = face;
  const int circle = closed.num_curves();
  closed.curves.push_back(circular_arc({0, 0}, 1, 0.3, 0.3 + 2 * pi));
  closed.curves.push_back({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {2, 1}, {-2, 1}, {0, 0}}, {1, 1, 1, 1}});
  const CurveTable table(closed, splines);
  const double end = closed.curves[circle].end();
  const Chain there(table, {{circle, end - 1, end}, {circle, 0, 1}});
  EXPECT_EQ(there.joint_fractions().size(), 1U);
  EXPECT_TRUE(there.break_fractions().empty());
  EXPECT_TRUE(Chain(table, {{circle, 1, 0}, {circle, end, end - 1}}).break_fractions().empty());
  EXPECT_EQ(Chain(table, {{circle + 1, 0.5, 1}, {circle + 1, 0, 0.5}}).break_fractions().size(), 1U);
}

}  // namespace

}  // namespace quadrille::curve
