#include "heal/joint_target.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {

namespace {

// Where the end of `in` and the start of `out` are joined, if both may move by `most`.
std::optional<Vec2> joined(const Nurbs& in, const Nurbs& out, double most = 1) {
  const RawFace raw = raw_face({in, out});
  const auto wires = measured(raw.wires);
  JointSide a = end_of(wires[0][0]), b = start_of(wires[0][1]);
  a.most = b.most = a.most_sliding = b.most_sliding = most;
  return joint_target(a, b);
}

const Nurbs flat = curve::segment({0, 0}, {10, 0});
const Nurbs bow{2, {0, 0, 0, 1, 1, 1}, {{10, 0.01}, {12, 1}, {13, 3}}, {1, 1, 1}};

void expect_at(const std::optional<Vec2>& x, Vec2 place) {
  ASSERT_TRUE(x);
  EXPECT_NEAR(distance(*x, place), 0, 1e-12) << x->x << ", " << x->y;
}

TEST(JointTarget, TwoLinesMeetAtTheirIntersection) {
  expect_at(joined(flat, curve::segment({10.01, 0.02}, {10.01, 5})), {10.01, 0});
}

TEST(JointTarget, NearlyParallelLinesMeetOnTheOneThatIsKept) {
  const Vec2 far = Vec2{10, 0.01} + 7 * unit(radians(0.5));
  expect_at(joined(flat, curve::segment({10, 0.01}, far)), {10, 0});
  expect_at(joined(curve::segment({0, 0}, {10, 0.1}), curve::segment({10, 0.11}, {17, 0.2})), {10, 0.105});
}

TEST(JointTarget, ATangentialArcEndsAtTheFootOfItsCentre) {
  // The circle overlaps the line by 1e-3: their crossings are 0.045 away from the foot, where the drawing meant them to
  // meet.
  const Nurbs arc = curve::circular_arc({10.03, 0.999}, 1, -half_pi - 0.01, 0);
  expect_at(joined(flat, arc), {10.03, 0});
}

TEST(JointTarget, AnArcThatCrossesALineMeetsItThere) {
  const Nurbs arc = curve::circular_arc({11, 0}, 1, pi - 0.01, half_pi);
  expect_at(joined(flat, arc), {10, 0});
}

TEST(JointTarget, TwoArcsMeetAtTheirIntersectionOrInTheMiddle) {
  const Nurbs arc = curve::circular_arc({0, 0}, 5, 0, std::atan2(4.01, 3));
  expect_at(joined(arc, curve::circular_arc({6, 0}, 5, pi - std::atan2(3.99, 3), half_pi)), {3, 4});
  const Vec2 top{0, 5}, start{0.02, 5.01};
  const Nurbs quarter = curve::circular_arc({0, 0}, 5, 0, half_pi);
  expect_at(joined(quarter, curve::circular_arc(start - Vec2{0, 2}, 2, half_pi, pi)), 0.5 * (top + start));
}

TEST(JointTarget, ASplineYieldsToALineAndToAnArc) {
  expect_at(joined(flat, bow), {10, 0});
  const Nurbs arc = curve::circular_arc({9, 0}, 1, -half_pi, 0);
  const Vec2 on = joined(arc, bow).value();
  EXPECT_NEAR(distance(on, {9, 0}), 1, 1e-15);
  EXPECT_NEAR(on.y, 0.005, 1e-4);
}

TEST(JointTarget, AShortLineMaySlideFurtherThanItMayTurn) {
  JointSide a{curve::carrier_of(flat), Rank::line, {10, 0}, {1, 0}, 0.01, 0.03};
  JointSide b{curve::carrier_of(curve::segment({10.02, 0}, {10.02, 1})), Rank::line, {10.02, 0}, {0, 1}, 0.01, 0.03};
  expect_at(joint_target(a, b), {10.02, 0});
  a.most_sliding = 0.015;
  expect_at(joint_target(a, b), {10.01, 0});
  a.rank = b.rank = Rank::kept_line;
  EXPECT_FALSE(joint_target(a, b));
}

TEST(JointTarget, TheToleranceThatIsNeededLetsKeptLinesSlideToTheirIntersection) {
  JointSide a{curve::carrier_of(flat), Rank::kept_line, {10, 0}, {1, 0}, 0, 0};
  JointSide b{curve::carrier_of(curve::segment({10, 0.01}, {20, 10.01})), Rank::kept_line, {10, 0.01}, {1, 1}, 0, 0};
  EXPECT_DOUBLE_EQ(needed_tolerance(a, b), 0.01) << "they meet at (9.99, 0)";
  b.carrier = curve::carrier_of(curve::segment({10, 0.01}, {20, 1.01}));  // at (9.9, 0)
  EXPECT_NEAR(needed_tolerance(a, b), std::hypot(0.1, 0.01) / 4, 1e-12);
  b.rank = Rank::line;
  EXPECT_DOUBLE_EQ(needed_tolerance(a, b), 0.01) << "it turns instead";
}

TEST(JointTarget, IsTheSameFromBothSides) {
  const Nurbs other = curve::segment({10.01, 0.02}, {12, 5});
  expect_at(joined(curve::reversed(other), curve::reversed(flat)), *joined(flat, other));
}

TEST(JointTarget, LeavesTheRuleWhosePointIsTooFar) {
  // The intersection is 0.57 away, the middle of the gap 0.005.
  const Vec2 far = Vec2{10, 0.01} + 7 * unit(radians(1.0001));
  const auto x = joined(flat, curve::segment({10, 0.01}, far), 0.02);
  ASSERT_TRUE(x);
  EXPECT_LT(distance(*x, {10, 0}), 1e-3);
  EXPECT_FALSE(joined(flat, curve::segment({10, 0.01}, far), 0.002));
}

TEST(JointTarget, TheCurveThatMayNotMoveKeepsItsEnd) {
  JointSide a, b;
  a.end = {0, 0}, b.end = {0.1, 0}, a.most = 0.01, b.most = 0.2;
  EXPECT_EQ(joint_target(a, b), (Vec2{0, 0}));
}

TEST(JointTarget, KeepsLinesAtMultiplesOf15DegreesAndParallels) {
  std::vector<curve::Carrier> lines;
  for (const double degrees_of : {45.0, 17.0, 80.0, 17.0 + 180, 90.0, 165.0})
    lines.push_back(curve::carrier_of(curve::segment({0, 0}, unit(radians(degrees_of)))));
  lines.push_back(curve::carrier_of(bow));
  using enum Rank;
  EXPECT_EQ(ranks_of(lines), (std::vector<Rank>{kept_line, kept_line, line, kept_line, kept_line, kept_line, spline}));
}

// The limits at the corner (4, 0) of a polygon.
LimitedJoint limited(const std::vector<Vec2>& polygon, double tolerance) {
  const RawFace raw = raw_polygon(polygon);
  const auto wires = measured(raw.wires);
  const JointLimit limit(raw.wires, tolerance);
  const auto& w = wires[0];
  return limit.joint(w[0], w[1], {w.back().raw, w[0].raw, w[1].raw, w[2].raw});
}

TEST(JointLimit, IsTheTolerance) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.01);
  EXPECT_DOUBLE_EQ(joint.in.most, 0.01);
  EXPECT_DOUBLE_EQ(joint.out.most, 0.01);
  EXPECT_EQ(joint.reason, LimitReason::tolerance);
}

TEST(JointLimit, LinesWhoseEndsAreNearSlideFourTolerances) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.01);
  EXPECT_DOUBLE_EQ(joint.in.most_sliding, 0.04);
  EXPECT_DOUBLE_EQ(joint.out.most_sliding, 0.04);
  EXPECT_DOUBLE_EQ(limited({{0, 0}, {4, 0}, {4, 0.1}, {0, 4}}, 0.01).out.most_sliding, 0.025)
      << "a quarter of the line";
}

TEST(JointLimit, IsATenthOfEachEdge) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 2}, {0, 4}}, 1);
  EXPECT_DOUBLE_EQ(joint.in.most, 0.4);
  EXPECT_DOUBLE_EQ(joint.out.most, 0.2);
  EXPECT_EQ(joint.reason, LimitReason::edge);
}

TEST(JointLimit, IsAQuarterOfTheDistanceToOtherEdges) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 4}, {5, 4}, {5, -1}, {4.4, -1}, {4.4, 0.3}, {4.1, 0}}, 1);
  EXPECT_NEAR(joint.in.most, 0.1 / 4, 1e-12);
  EXPECT_EQ(joint.reason, LimitReason::clearance);
}

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
