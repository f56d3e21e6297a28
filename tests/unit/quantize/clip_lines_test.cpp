#include "quantize/clip_lines.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::quantize {
namespace {

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
