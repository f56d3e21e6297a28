#include "sew/cut_curve.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::sew {
namespace {

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

}  // namespace
}  // namespace quadrille::sew
