#include "curve/carrier.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

const Carrier axis = carrier_of(segment({-1, 0}, {4, 0}));

TEST(Carrier, KnowsLinesAndArcs) {
  EXPECT_EQ(axis.kind, CurveKind::line);
  EXPECT_EQ(axis.direction, (Vec2{1, 0}));
  const Carrier arc = carrier_of(circular_arc({3, 1}, 2, 0.3, 4));
  EXPECT_EQ(arc.kind, CurveKind::arc);
  EXPECT_NEAR(distance(arc.point, {3, 1}), 0, 1e-14);
  EXPECT_NEAR(arc.radius, 2, 1e-14);
  EXPECT_EQ(carrier_of(circular_arc({3, 1}, 2, 0, 2 * pi)).kind, CurveKind::arc);
}

TEST(Carrier, AnEllipseAndAPolylineAreSplines) {
  Nurbs ellipse = circular_arc({0, 0}, 1, 0, 3);
  for (Vec2& pole : ellipse.poles) pole.y *= 1 + 1e-6;
  EXPECT_EQ(carrier_of(ellipse).kind, CurveKind::spline);
  EXPECT_EQ(carrier_of({1, {0, 0, 1, 2, 2}, {{0, 0}, {1, 0}, {2, 0}}, {1, 1, 1}}).kind, CurveKind::spline);
  EXPECT_EQ(carrier_of({2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 0}, {2, 0}}, {1, 1, 1}}).kind, CurveKind::spline);
}

TEST(Carrier, IntersectionsAreThoseNearestToThePoint) {
  const Carrier circle = carrier_of(circular_arc({0, 0}, 5, 0, 1));
  const Carrier line = carrier_of(segment({-9, 3}, {9, 3}));
  EXPECT_NEAR(distance(*intersection(line, circle, {4, 3.1}), {4, 3}), 0, 1e-14);
  EXPECT_NEAR(distance(*intersection(circle, line, {-4, 3}), {-4, 3}), 0, 1e-14);
  const Carrier other = carrier_of(circular_arc({6, 0}, 5, 0, 1));
  EXPECT_NEAR(distance(*intersection(circle, other, {3, 9}), {3, 4}), 0, 1e-13);
  EXPECT_NEAR(distance(*intersection(circle, other, {3, -9}), {3, -4}), 0, 1e-13);
  const Carrier slope = carrier_of(segment({0, 0}, {1, 1}));
  EXPECT_NEAR(distance(*intersection(slope, line, {0, 0}), {3, 3}), 0, 1e-14);
}

TEST(Carrier, WhatDoesNotCrossHasNoIntersection) {
  EXPECT_FALSE(intersection(axis, carrier_of(segment({0, 1}, {1, 1})), {0, 0}));
  EXPECT_FALSE(intersection(axis, carrier_of(circular_arc({0, 3}, 2, 0, 1)), {0, 0}));
  EXPECT_FALSE(intersection(axis, Carrier{}, {0, 0}));
}

}  // namespace
}  // namespace quadrille::curve
