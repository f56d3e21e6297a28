#include "sizing/curve_sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "base/angle.hpp"

namespace quadrille::sizing {
namespace {

const double slope = std::log(1.2);

TEST(BoundarySizes, SizesGrowFromTheExactCircle) {
  for (const double sense : {1.0, -1.0}) {
    const Nurbs circle = curve::circular_arc({1, 2}, 3, 0.1, 0.1 + sense * 2 * pi);
    const SizeField sizes(10, {}, segments_near(circle, 0.01, slope), 1.2);
    for (const double angle : {0.0, 0.7, 2.9, 4.4})
      for (const double away : {-2.0, -0.1, 0.0, 0.3, 5.0})
        EXPECT_NEAR(sizes.at(Vec2{1, 2} + (3 + away) * unit(angle)), 0.01 + slope * std::abs(away), 1e-14);
  }
}

TEST(BoundarySizes, BesideAnArcItsEndsCount) {
  const Vec2 centre{1, 2}, end{1, 5};
  const SizeField sizes(10, {}, segments_near(curve::circular_arc(centre, 3, 0, half_pi), 0.01, slope), 1.2);
  for (const Vec2 x : {Vec2{0, 4}, Vec2{-2, 3}, Vec2{0.5, 6}})
    EXPECT_NEAR(sizes.at(x), 0.01 + slope * distance(x, end), 1e-14);
}

TEST(BoundarySizes, SegmentsStayNearASpline) {
  const Nurbs parabola{2, {-1, -1, -1, 1, 1, 1}, {{-1, 1}, {0, -1}, {1, 1}}, {1, 1, 1}};
  const SizeField sizes(10, {}, segments_near(parabola, 0.01, slope), 1.2);
  for (const double x : {-0.9, -0.31, 0.0, 0.77}) EXPECT_NEAR(sizes.at({x, x * x}), 0.01, 1e-7) << x;
  EXPECT_NEAR(sizes.at({0, -2}), 0.01 + slope * 2, 1e-7);
}

TEST(BoundarySizes, StraightCurvesAreTheirPolesAndHaveNoCurvature) {
  EXPECT_EQ(segments_near(curve::segment({0, 0}, {1, 0}), 0.1, slope).size(), 1u);
  EXPECT_TRUE(segments_by_curvature(curve::segment({0, 0}, {1, 0}), 50, 1e-3, 1, slope).empty());
}

TEST(BoundarySizes, ACircleGetsItsElementsPerTurn) {
  const std::vector<SizeSegment> segments =
      segments_by_curvature(curve::circular_arc({0, 0}, 2, 0, 2 * pi), 50, 1e-3, 10, slope);
  ASSERT_FALSE(segments.empty());
  for (const SizeSegment& s : segments) EXPECT_NEAR(s.size_a, 2 * pi * 2 / 50, 1e-12);
  EXPECT_TRUE(segments_by_curvature(curve::circular_arc({0, 0}, 2, 0, 2 * pi), 3, 1e-3, 2, slope).empty())
      << "more than the greatest size";
  EXPECT_EQ(segments_by_curvature(curve::circular_arc({0, 0}, 2, 0, 2 * pi), 50, 0.5, 10, slope)[0].size_a, 0.5);
}

TEST(BoundarySizes, CurvatureOfAParabolaIsFollowed) {
  // y = x^2 has the curvature 2 / (1 + 4 x^2)^(3/2).
  const Nurbs parabola{2, {-1, -1, -1, 1, 1, 1}, {{-1, 1}, {0, -1}, {1, 1}}, {1, 1, 1}};
  const SizeField sizes(100, {}, segments_by_curvature(parabola, 20, 1e-3, 100, 10), std::exp(10.0));
  for (const double x : {-0.9, -0.31, 0.0, 0.2, 0.77}) {
    const double wanted = 2 * pi / 20 * std::pow(1 + 4 * x * x, 1.5) / 2;
    EXPECT_NEAR(sizes.at({x, x * x}), wanted, 1e-4 * wanted) << x;
  }
}

TEST(BoundarySizes, StraightEdgesKeepTheirDistanceFromTheCurve) {
  const Nurbs circle = curve::circular_arc({0, 0}, 2, 0, 2 * pi);
  const double size = 0.4, sag = 2 - std::sqrt(4 - size * size / 4);  // of an edge of this length
  const std::vector<SizeSegment> segments = segments_by_sag(circle, sag, 10, slope);
  ASSERT_FALSE(segments.empty());
  for (const SizeSegment& s : segments) EXPECT_NEAR(s.size_a, size, 1e-3);
  EXPECT_TRUE(segments_by_sag(circle, sag, 0.3, slope).empty()) << "more than the greatest size";
  EXPECT_TRUE(segments_by_sag(curve::segment({0, 0}, {1, 0}), sag, 10, slope).empty());
}

TEST(SizesAtBends, EdgesTurnBy15DegreesButAreNotShorterThanThreeQuarters) {
  const double length = 2 * pi / 24;  // of a 24th of the unit circle
  const CadFace disc = hand_made::face({{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}}, 2);
  const auto on_circle = [&](double size) { return sizes_at_bends(disc, SizeField(size)).at(unit(0.3)); };
  EXPECT_NEAR(on_circle(length * 1.1), length, 1e-6);
  EXPECT_NEAR(on_circle(length * 2), 0.75 * length * 2, 1e-6);
  EXPECT_EQ(on_circle(length * 0.9), length * 0.9);
  EXPECT_TRUE(sizes_at_bends(hand_made::unit_square().face, SizeField(0.1)).is_uniform()) << "nothing is bent";
}

TEST(SizesAtBends, PrescribedSizesStayAndGrowAsBefore) {
  const CadFace disc = hand_made::face({{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}}, 2);
  const SizeField sizes = sizes_at_bends(disc, SizeField(0.4, {{{{1, 0}, 0.1, 0}}, {}, 0}, {}, 1.3));
  EXPECT_EQ(sizes.at({1, 0}), 0.1);
  EXPECT_NEAR(sizes.at({1.5, 0}), 0.1 + std::log(1.3) * 0.5, 1e-12);
  EXPECT_NEAR(sizes.at({-1, 0}), 0.75 * 0.4, 1e-6);
  EXPECT_NEAR(sizes.at({-1.2, 0}), 0.75 * 0.4 + std::log(1.3) * 0.2, 1e-5);
}

}  // namespace
}  // namespace quadrille::sizing
