#include "sew/cut_curve.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::sew {

namespace {

TEST(JoinedCurve, IsTheCircleAcrossItsSeam) {
  const Nurbs circle = curve::circular_arc({1, 2}, 3, 0, 2 * pi);
  const Nurbs tail = curve::trimmed(circle, 5, circle.end());
  Nurbs head = curve::trimmed(circle, 0, 1);
  for (double& weight : head.weights) weight *= 3;  // the same curve
  const Nurbs joined = joined_curve(tail, head);
  EXPECT_EQ(joined.knots.size(), joined.poles.size() + 3);
  EXPECT_EQ(joined.weights.size(), joined.poles.size());
  EXPECT_NEAR(joined.end() - joined.begin(), 2 * pi - 4, 1e-14);
  for (double t = joined.begin(); t <= joined.end(); t += 0.05)
    EXPECT_NEAR(distance(curve::point(joined, t), {1, 2}), 3, 1e-14);
  EXPECT_NEAR(distance(curve::point(joined, 2 * pi + 0.5), curve::point(circle, 0.5)), 0, 1e-14);
  EXPECT_TRUE(curve::smoothness_breaks(joined).empty());
}

TEST(JoinedCurve, RefusesDifferentDegrees) {
  EXPECT_THROW(joined_curve(curve::segment({0, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, 1)), Defect);
}

TEST(CutCurve, AnOpenCurveStartsAtItsPlace) {
  const std::vector<CutPiece> pieces = cut_curve(curve::segment({0, 0}, {4, 0}), {{3, 8}, {1, 7}}, 5);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].start, 5);
  EXPECT_EQ(pieces[1].start, 7);
  EXPECT_EQ(pieces[2].start, 8);
  EXPECT_EQ(pieces[1].curve.poles, (std::vector<Vec2>{{1, 0}, {3, 0}}));
}

TEST(CutCurve, AClosedCurveWithoutCutsStaysWhole) {
  const std::vector<CutPiece> pieces = cut_curve(curve::circular_arc({0, 0}, 1, 0, 2 * pi), {}, -1);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].start, -1);
}

// Two cuts, one of them on the seam or in either direction beside it: half circles in any case.
TEST(CutCurve, TheSeamOfAClosedCurveIsNoEnd) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi);
  for (const double t : {0.0, 1e-13, 0.5, 2.0, 2 * pi - 1e-13, 2 * pi}) {
    const std::vector<CutPiece> pieces = cut_curve(circle, {{t, 1}, {std::fmod(t + pi, 2 * pi), 2}}, -1);
    ASSERT_EQ(pieces.size(), 2U) << t;
    for (const CutPiece& piece : pieces) {
      const Vec2 start = (piece.start == 1 ? 1 : -1) * curve::point(circle, t);
      EXPECT_NEAR(distance(piece.curve.poles.front(), start), 0, 1e-9) << t;
      EXPECT_NEAR(distance(piece.curve.poles.back(), -start), 0, 1e-9) << t;
    }
  }
}

TEST(CutCurve, ACutBesideAKnotIsAtTheKnot) {
  const Nurbs curve{2, {0, 0, 0, 1, 2, 2, 2}, {{0, 0}, {1, 1}, {2, 1}, {3, 0}}, {1, 1, 1, 1}};
  for (const double t : {1 - 1e-13, 1 + 1e-13}) {
    const std::vector<CutPiece> pieces = cut_curve(curve, {{t, 1}}, 0);
    ASSERT_EQ(pieces.size(), 2U);
    for (const CutPiece& piece : pieces) EXPECT_EQ(piece.curve.poles.size(), 3U) << "a piece of one span";
  }
}

TEST(CurveCrossings, OfALineAndACircleAreExact) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), line = curve::segment({-2, 0.6}, {2, 0.6});
  const auto found = curve_crossings(line, circle, 1e-6, "x");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(distance(found[0].position, {-0.8, 0.6}), 0, 1e-14);
  EXPECT_NEAR(distance(found[1].position, {0.8, 0.6}), 0, 1e-14);
  EXPECT_NEAR(distance(curve::point(circle, found[1].t_b), {0.8, 0.6}), 0, 1e-14);
}

TEST(CurveCrossings, AtKnotsCountOnce) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), line = curve::segment({0, -2}, {0, 2});
  EXPECT_EQ(curve_crossings(line, circle, 1e-6, "x").size(), 2U);
  EXPECT_EQ(curve_crossings(circle, line, 1e-6, "x").size(), 2U);
}

TEST(CurveCrossings, OfDistantOrParallelLinesAreNone) {
  EXPECT_TRUE(curve_crossings(curve::segment({0, 0}, {1, 0}), curve::segment({0, 1}, {1, 1}), 1e-6, "x").empty());
  EXPECT_TRUE(curve_crossings(curve::segment({0, 0}, {1, 0}), curve::segment({2, -1}, {2, 1}), 1e-6, "x").empty());
}

TEST(CurveCrossings, ACurveThatFollowsAnotherOneSmoothlyDoesNotCrossIt) {
  const Nurbs arc = curve::circular_arc({0, 1}, 1, 0, 1.5 * pi), line = curve::segment({0, 0}, {2, 0});
  EXPECT_TRUE(curve_crossings(arc, line, 1e-6, "x").empty());
  EXPECT_THROW(curve_crossings(arc, curve::segment({-1, 0}, {1, 0}), 1e-6, "x"), FormatError) << "not at its end";
}

TEST(CurveCrossings, CurvesAlongEachOtherAreRefused) {
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi), arc = curve::circular_arc({0, 0}, 1, 1, 2);
  EXPECT_THROW(curve_crossings(circle, arc, 1e-6, "edges 1 and 2"), FormatError);
  EXPECT_THROW(curve_crossings(circle, curve::segment({-1, 1 - 1e-9}, {1, 1 - 1e-9}), 1e-6, "edges 1 and 2"),
               FormatError);
}

}  // namespace

}  // namespace quadrille::sew
