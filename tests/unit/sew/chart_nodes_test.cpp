#include "sew/chart_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "charted_square.hpp"

namespace quadrille::sew {
namespace {

using namespace testing_charts;
using testing_regions::circle;

std::vector<ChartPiece> pieces(const std::vector<ChartCurve>& curves, double tolerance = 1e-5) {
  return chart_pieces(charted_square(), curves, {"x.step", tolerance});
}

std::vector<ChartPiece> of_curve(const std::vector<ChartPiece>& all, int curve) {
  std::vector<ChartPiece> own;
  for (const ChartPiece& piece : all)
    if (piece.curve == curve) own.push_back(piece);
  return own;
}

TEST(ChartPieces, WithoutInnerCurvesAreThoseOfTheBoundary) {
  const std::vector<ChartPiece> all = pieces({});
  ASSERT_EQ(all.size(), 4u);
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(all[c].curve, c);
    EXPECT_EQ(all[c].to, all[(c + 1) % 4].from);
    EXPECT_TRUE(all[c].is_first && all[c].is_last);
  }
}

TEST(ChartPieces, AnEndWithinTheToleranceOfAJointIsTheJoint) {
  const std::vector<ChartPiece> all = pieces({line({3e-6, 4e-6}, {1, 1})});
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[4].from, all[0].from);
  EXPECT_EQ(all[4].image.poles.front(), (Vec2{0, 0})) << "bit for bit";
  EXPECT_EQ(all[4].space.poles.front(), all[0].space.poles.front());
}

TEST(ChartPieces, ACrossingIsANodeOfBoth) {
  const std::vector<ChartPiece> all = pieces({line({0.5, 0.5}, {1.5, 1.5}), line({0.5, 1.5}, {1.5, 0.5})});
  const std::vector<ChartPiece> a = of_curve(all, 4), b = of_curve(all, 5);
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  EXPECT_EQ(a[0].to, b[0].to);
  EXPECT_EQ(a[0].to, b[1].from);
  EXPECT_EQ(a[0].image.poles.back(), b[1].image.poles.front());
  EXPECT_LT(distance(a[0].image.poles.back(), {1, 1}), 1e-12);
  EXPECT_TRUE(a[0].is_first && !a[0].is_last && a[1].is_last);
  EXPECT_EQ(a[1].image.begin(), a[0].image.end()) << "parameters stay";
}

/// The end is 4e-6 away and moves onto the curve.
TEST(ChartPieces, AnEndBesideAnotherCurveCutsItThere) {
  const std::vector<ChartPiece> all = pieces({line({0.5, 1}, {1.5, 1}), line({1, 1 + 4e-6}, {1, 1.5})});
  const std::vector<ChartPiece> cut = of_curve(all, 4), other = of_curve(all, 5);
  ASSERT_EQ(cut.size(), 2u);
  ASSERT_EQ(other.size(), 1u);
  EXPECT_EQ(other[0].from, cut[0].to);
  EXPECT_EQ(other[0].image.poles.front().y, 1);
  EXPECT_EQ(other[0].space.poles.front(), cut[1].space.poles.front());
}

TEST(ChartPieces, AnEndJustBeforeAnotherCurveIsRefusedWithTheToleranceThatWouldDo) {
  EXPECT_EQ(message_of<FormatError>([] {
              pieces({line({1, 1e-3}, {1, 1})});
            }),
            "x.step: the curve of edge 9 ends at (1, 0.001, 3), 0.001 before edge 0: let it end there, or give "
            "--heal-tolerance 0.0005");
  EXPECT_EQ(pieces({line({1, 1e-3}, {1, 1})}, 2e-3).size(), 6u);
  EXPECT_EQ(pieces({line({1, 0.01}, {1, 1})}).size(), 5u) << "it ends inside on purpose";
}

TEST(ChartPieces, ACircleInsideIsOnePieceAndIsCutWhereAnotherCurveCrossesIt) {
  const Nurbs round = circle({1, 1}, 0.4).front().curve;
  const std::vector<ChartPiece> whole = of_curve(pieces({inner(round)}), 4);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].from, whole[0].to);
  EXPECT_TRUE(whole[0].is_first && whole[0].is_last);
  const std::vector<ChartPiece> halves = of_curve(pieces({inner(round), line({1, 0.3}, {1, 1.8})}), 4);
  ASSERT_EQ(halves.size(), 2u);
  EXPECT_EQ(halves[0].from, halves[1].to);
  EXPECT_FALSE(halves[0].is_first || halves[1].is_last) << "its seam is no end";
}

TEST(ChartPieces, OfCurvesAlongEachOtherOneRemains) {
  EXPECT_EQ(pieces({line({0.5, 1}, {1.5, 1}), line({1.5, 1}, {0.5, 1})}).size(), 5u);
  EXPECT_EQ(pieces({line({0, 0}, {2, 0})}).size(), 4u) << "along the boundary";
  EXPECT_EQ(pieces({line({0.5, 0}, {1.5, 0})}).size(), 6u) << "along a part of it, which is cut";
}

}  // namespace
}  // namespace quadrille::sew
