#include "trace/merged_lines.hpp"

#include <gtest/gtest.h>

#include "../support/two_nodes.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::trace {
namespace {

struct MergedTwoNodes : TwoNodes {
  MergedLines merged(double degrees_allowed, LineEnds ends = LineEnds::required, double reach = 0) const {
    return MergedLines(*evaluator, lines, nodes, radians(degrees_allowed), 0, ends, {reach});
  }
  void follow_only_to(double length) {
    for (Streamline& line : lines)
      line = advance(*evaluator, line.launch, PointGrid(nodes), {1e-11, 0.1, length, 1e-7});
  }
};

TEST_F(MergedTwoNodes, AMergedPairIsOneLineFromNodeToNode) {
  make(0.2);
  MergedLines all = merged(20);
  ASSERT_TRUE(all.merge());
  ASSERT_EQ(all.chosen().size(), 1u);
  ASSERT_EQ(all.arrangement().lines.size(), 5u);
  int num_merged = 0;
  for (const MergedLine& line : all.arrangement().lines) {
    if (line.merge < 0) {
      EXPECT_GE(line.line.end.curve, 0);
      continue;
    }
    ++num_merged;
    EXPECT_EQ(line.line.kind, LineKind::merged);
    EXPECT_EQ(line.line.start.node, 0);
    EXPECT_EQ(line.line.end.node, 1);
    EXPECT_LT(distance(curve::point(line.line.spline, line.length), nodes[1]), 1e-9);
  }
  EXPECT_EQ(num_merged, 1);
  EXPECT_GT(all.largest_deviation(), radians(1));
}

TEST_F(MergedTwoNodes, ARejectedMergeLeavesBothLines) {
  make(0.2);
  MergedLines all = merged(20);
  all.merge();
  EXPECT_FALSE(all.reject_worst(all.chosen(), 2 * all.largest_deviation()));
  ASSERT_TRUE(all.reject_worst(all.chosen(), 0));
  all.merge();
  EXPECT_EQ(all.arrangement().lines.size(), 6u);
  EXPECT_EQ(all.largest_deviation(), 0);
}

TEST_F(MergedTwoNodes, ARejectedPairStaysRejectedWhenItsLinesAreFollowedFarther) {
  make(0.2);
  follow_only_to(1.2);
  MergedLines all = merged(20, LineEnds::optional);
  all.merge();
  ASSERT_EQ(all.chosen().size(), 1u);
  ASSERT_TRUE(all.reject_worst(all.chosen(), 0));
  follow_only_to(10);
  all.renew();
  all.merge();
  EXPECT_TRUE(all.chosen().empty());
}

TEST_F(MergedTwoNodes, LinesWithoutAnEndAreAnErrorOnlyWhereEndsAreRequired) {
  make(0.2);
  follow_only_to(0.3);
  EXPECT_THROW(merged(0.1).merge(), ComputeError);
  MergedLines stopped = merged(0.1, LineEnds::optional);
  EXPECT_TRUE(stopped.merge());
  EXPECT_EQ(stopped.arrangement().lines.size(), 6u);
}

TEST_F(MergedTwoNodes, LinesThatAreTooShortToDecideSaySo) {
  make(0.2);
  follow_only_to(0.3);
  EXPECT_FALSE(merged(20, LineEnds::required, 0.3).merge());
}

TEST_F(MergedTwoNodes, CrossingsAtACommonEndAreNotInner) {
  make(0);
  MergedLines all = merged(20);
  all.merge();
  for (const graph::Crossing& c : all.arrangement().inner_crossings)
    for (const Vec2 node : nodes) EXPECT_GT(distance(c.position, node), 1e-6);
}

}  // namespace
}  // namespace quadrille::trace
