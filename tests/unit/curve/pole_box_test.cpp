#include "curve/pole_box.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {

namespace {

TEST(PoleBox, of_a_segment_has_its_ends_as_corners) {
  const PoleBox box = pole_box(segment({3, 1}, {-1, 4}));
  EXPECT_EQ(box.low, (Vec2{-1, 1}));
  EXPECT_EQ(box.high, (Vec2{3, 4}));
  EXPECT_EQ(box.centre(), (Vec2{1, 2.5}));
  EXPECT_DOUBLE_EQ(box.diagonal(), 5);
}

TEST(PoleBox, of_an_arc_contains_it) {
  const Nurbs arc = circular_arc({5, -2}, 2, 0.3, 2.9);
  const PoleBox box = pole_box(arc);
  for (int i = 0; i <= 100; ++i)
    EXPECT_TRUE(box.contains(point(arc, arc.begin() + (arc.end() - arc.begin()) * i / 100)));
}

TEST(PoleBox, of_several_curves_contains_the_last_one_too) {
  const PoleBox box = pole_box(std::vector<Nurbs>{segment({0, 0}, {1, 0}), segment({1, 0}, {7, -3})});
  EXPECT_EQ(box.low, (Vec2{0, -3}));
  EXPECT_EQ(box.high, (Vec2{7, 0}));
}

TEST(PoleBox, a_margin_widens_every_side) {
  const PoleBox box = pole_box(segment({0, 0}, {2, 1}));
  for (const Vec2 x : {Vec2{-0.1, 0.5}, Vec2{2.1, 0.5}, Vec2{1, -0.1}, Vec2{1, 1.1}}) {
    EXPECT_FALSE(box.contains(x));
    EXPECT_FALSE(box.contains(x, 0.05));
    EXPECT_TRUE(box.contains(x, 0.15));
  }
}

TEST(PoleBox, is_nearer_than_its_curve) {
  const std::vector<PoleBox> boxes{pole_box(circular_arc({3, 1}, 0.5, 0, 2 * pi)), pole_box(segment({-1, 4}, {-2, 4}))};
  EXPECT_EQ(boxes[0].distance_from({3, 1}), 0);
  EXPECT_NEAR(boxes[0].distance_from({5, 1}), 1.5, 1e-15);
  EXPECT_EQ(boxes[1].distance_from({2, 8}), 5);
  for (const Vec2 x : {Vec2{0, 0}, Vec2{5, 2}, Vec2{-1, -2}})
    EXPECT_LE(boxes[0].distance_from(x), distance(x, {3, 1}) - 0.5 + 1e-15);
}

TEST(PoleBox, meets_a_box_with_a_common_point_or_within_the_margin) {
  const PoleBox box{{0, 0}, {2, 1}};
  EXPECT_TRUE(box.meets({{2, 1}, {3, 3}}));
  EXPECT_TRUE(box.meets({{-1, -1}, {3, 3}}));
  for (const PoleBox& apart : {PoleBox{{2.1, 0}, {3, 1}}, PoleBox{{0, 1.1}, {2, 2}}, PoleBox{{-1, 0}, {-0.1, 1}}}) {
    EXPECT_FALSE(box.meets(apart));
    EXPECT_FALSE(apart.meets(box));
    EXPECT_TRUE(box.meets(apart, 0.11));
    EXPECT_FALSE(box.meets(apart, 0.09));
  }
}

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
