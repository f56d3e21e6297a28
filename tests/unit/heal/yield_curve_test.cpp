#include "heal/yield_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/carrier.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::heal {
namespace {

TEST(YieldCurve, ALineStaysALine) {
  const auto pieces = moved_curve(curve::segment({0, 0}, {4, 0}), {0, 0}, {4, 0.1});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].poles, (std::vector<Vec2>{{0, 0}, {4, 0.1}}));
}

TEST(YieldCurve, AnArcGrowsOnItsCircle) {
  const Nurbs arc = curve::circular_arc({1, 2}, 3, 0, 1);
  const Vec2 end = Vec2{1, 2} + 3 * unit(1.01);
  const auto pieces = moved_curve(arc, arc.poles.front(), end);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].poles.back(), end);
  const curve::Carrier circle = curve::carrier_of(pieces[0]);
  EXPECT_NEAR(distance(circle.point, {1, 2}), 0, 1e-12);
  EXPECT_NEAR(circle.radius, 3, 1e-12);
}

TEST(YieldCurve, ClockwiseArcsKeepTheirSense) {
  const Nurbs arc = curve::circular_arc({0, 0}, 1, 2, -2);
  const Vec2 end = unit(-2.01);
  const auto pieces = moved_curve(arc, arc.poles.front(), end);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(distance(curve::point(pieces[0], (pieces[0].begin() + pieces[0].end()) / 2), unit(-0.005)), 0, 1e-12);
}

TEST(YieldCurve, AnArcOffItsNewEndStaysAnArc) {
  const Nurbs arc = curve::circular_arc({0, 0}, 1, 0, 2);
  const Vec2 end = 1.001 * unit(2);
  const auto pieces = moved_curve(arc, arc.poles.front(), end);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].poles.back(), end);
  EXPECT_EQ(curve::carrier_of(pieces[0]).kind, curve::CurveKind::arc);
  // The turn is at most the gap over the chord.
  const Vec2 before = curve::tangent(arc, arc.begin()), after = curve::tangent(pieces[0], pieces[0].begin());
  EXPECT_LE(std::abs(cross(before, after)), 1e-3 / distance(arc.poles.front(), arc.poles.back()));
}

TEST(YieldCurve, ASplineIsMappedAsAWhole) {
  // The first two poles coincide: to move the first one alone would turn the tangent by any angle.
  const Nurbs spline{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {2, 1}, {4, 0}}, {1, 1, 1, 1}};
  const auto pieces = moved_curve(spline, {0, 0.01}, {4, 0});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(distance(pieces[0].poles[0], pieces[0].poles[1]), 0, 1e-15);
  const Vec2 before = curve::tangent(spline, 0), after = curve::tangent(pieces[0], 0);
  EXPECT_NEAR(std::abs(cross(before, after)), 0.01 / 4, 1e-4);
}

TEST(YieldCurve, LongArcsAreCutInTheirMiddleWhichStays) {
  const Nurbs arc = curve::circular_arc({0, 0}, 1, 0, radians(330));
  const auto pieces = moved_curve(arc, {1.001, 0}, arc.poles.back());
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].poles.back(), pieces[1].poles.front());
  EXPECT_NEAR(distance(pieces[0].poles.back(), unit(radians(165))), 0, 1e-6);
  for (const Nurbs& piece : pieces)
    for (int i = 0; i <= 8; ++i) {
      const Vec2 x = curve::point(piece, piece.begin() + (piece.end() - piece.begin()) * i / 8);
      EXPECT_LE(curve::project(arc, x).distance, 1.1e-3);
    }
}

TEST(YieldCurve, AWholeCircleStaysWhole) {
  const Nurbs circle = curve::circular_arc({2, 0}, 1, 0.5, 0.5 + 2 * pi - 1e-4);
  const Vec2 seam = Vec2{2, 0} + unit(0.5 - 5e-5);
  const auto pieces = moved_curve(circle, seam, seam);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].poles.front(), pieces[0].poles.back());
  EXPECT_NEAR(distance(curve::point(pieces[0], (pieces[0].begin() + pieces[0].end()) / 2), Vec2{2, 0} - unit(0.5)), 0,
              1e-4);
}

}  // namespace
}  // namespace quadrille::heal
