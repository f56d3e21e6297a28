#include "quantize/motorcycle_graph.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::quantize {
namespace {

constexpr double tie = 1e-6;

graph::Crossing at(int a, double s, int b, double t) { return {a, b, s, t, {}, 1.5}; }

TEST(MotorcycleGraph, TheLaterOneStopsAndTheEarlierGoesOn) {
  const auto covered = trace_motorcycle_graph({{10}, {10}}, {at(0, 3, 1, 2)}, tie);
  EXPECT_FALSE(covered[0].is_whole());
  EXPECT_EQ(covered[0].first, 3);
  EXPECT_TRUE(covered[1].is_whole());
}

TEST(MotorcycleGraph, AStoppedLineStopsNobodyBehindItsEnd) {
  // Line 1 would cut line 2, but has been stopped by line 0 before.
  const auto covered = trace_motorcycle_graph({{10}, {10}, {10}}, {at(0, 1, 1, 2), at(1, 3, 2, 4)}, tie);
  EXPECT_EQ(covered[1].first, 2);
  EXPECT_TRUE(covered[2].is_whole());
}

TEST(MotorcycleGraph, ALineStopsAtItsOwnTrail) {
  const auto covered = trace_motorcycle_graph({{100}}, {at(0, 5, 0, 30)}, tie);
  EXPECT_EQ(covered[0].first, 30);
}

TEST(MotorcycleGraph, ATieLetsBothPassButOnlyOnce) {
  const auto covered = trace_motorcycle_graph({{10}, {10}}, {at(0, 3, 1, 3 + 1e-9), at(0, 5, 1, 5)}, tie);
  EXPECT_EQ(covered[0].is_whole() + covered[1].is_whole(), 1);
  EXPECT_EQ(std::min(covered[0].first, covered[1].first), 5);
}

TEST(MotorcycleGraph, TheTwoFrontsOfAMergedLineMeet) {
  const auto covered = trace_motorcycle_graph({{10, true}, {20}}, {at(0, 4, 1, 15)}, tie);
  EXPECT_TRUE(covered[0].is_whole());
  EXPECT_EQ(covered[1].first, 15);
}

TEST(MotorcycleGraph, AMergedLineIsCutWhereBothFrontsAreStopped) {
  const auto covered = trace_motorcycle_graph({{10, true}, {20}, {20}}, {at(0, 3, 1, 1), at(0, 8, 2, 1)}, tie);
  EXPECT_FALSE(covered[0].is_whole());
  EXPECT_EQ(covered[0].first, 3);
  EXPECT_EQ(covered[0].last, 8);
}

TEST(MotorcycleGraph, FrontsOfAMergedLineThatComeToOneCrossingFromBothSidesPassIt) {
  // Line 1 was there first; the front from 0 stops at it, the one from the end comes to the same place.
  const auto covered = trace_motorcycle_graph({{10, true}, {20}}, {at(0, 4, 1, 1)}, tie);
  EXPECT_TRUE(covered[0].is_whole());
  EXPECT_TRUE(covered[1].is_whole());
}

TEST(MotorcycleGraph, ACutIsThereBeforeTheOthers) {
  const auto covered = trace_motorcycle_graph({{10}, {10, false, 100}}, {at(0, 1, 1, 9)}, tie);
  EXPECT_EQ(covered[0].first, 1);
  EXPECT_TRUE(covered[1].is_whole());
}

constexpr double never = std::numeric_limits<double>::infinity();

// A straight line from (0, y) to (10, y), parameter x.
trace::MergedLine line(double y) {
  const Nurbs spline = curve::cubic_spline({0, 5, 10}, {{0, y}, {5, y}, {10, y}}, {1, 0}, {1, 0});
  trace::MergedLine line;
  line.line = {{3, -1, 0}, {4, -1, 0}, spline, LineKind::traced};
  line.length = 10;
  return line;
}

trace::LineArrangement two_lines(const std::vector<graph::Crossing>& crossings) {
  return {{line(0), line(1)}, crossings, crossings};
}

TEST(ClipLines, AWholeLineStaysAsItIs) {
  const ClippedLines clipped = clip_lines(two_lines({}), {{never, 10}, {never, 10}});
  ASSERT_EQ(clipped.pieces.size(), 2u);
  EXPECT_EQ(clipped.piece2line, (std::vector<int>{0, 1}));
  EXPECT_EQ(clipped.pieces[0].spline.end(), 10);
  EXPECT_EQ(clipped.pieces[0].end.node, 4);
}

TEST(ClipLines, AStoppedLineEndsOnAnother) {
  const ClippedLines clipped = clip_lines(two_lines({}), {{never, 10}, {6, never}});
  ASSERT_EQ(clipped.pieces.size(), 2u);
  EXPECT_EQ(clipped.pieces[1].spline.end(), 6);
  EXPECT_EQ(clipped.pieces[1].start.node, 3);
  EXPECT_TRUE(clipped.pieces[1].end.is_on_line());
}

TEST(ClipLines, ALineStoppedFromBothEndsHasTwoPieces) {
  const ClippedLines clipped = clip_lines(two_lines({}), {{3, 8}, {never, 10}});
  ASSERT_EQ(clipped.pieces.size(), 3u);
  EXPECT_EQ(clipped.piece2line, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(clipped.pieces[0].spline.end(), 3);
  EXPECT_EQ(clipped.pieces[1].spline.begin(), 8);
  EXPECT_TRUE(clipped.pieces[1].start.is_on_line());
  EXPECT_EQ(clipped.pieces[1].end.node, 4);
}

TEST(ClipLines, CrossingsOutsideThePiecesAreDropped) {
  const graph::Crossing kept{0, 1, 3, 2, {}, half_pi}, lost{0, 1, 5, 4, {}, half_pi}, second{0, 1, 9, 5, {}, half_pi};
  const ClippedLines clipped = clip_lines(two_lines({kept, lost, second}), {{3, 8}, {never, 10}});
  ASSERT_EQ(clipped.crossings.size(), 2u);
  EXPECT_EQ(clipped.crossings[0].a, 0);
  EXPECT_EQ(clipped.crossings[0].b, 2);
  EXPECT_EQ(clipped.crossings[1].a, 1);
  EXPECT_EQ(clipped.crossings[1].s, 9);
}

}  // namespace
}  // namespace quadrille::quantize
