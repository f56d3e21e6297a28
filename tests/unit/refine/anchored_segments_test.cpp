#include "refine/anchored_segments.hpp"

#include <gtest/gtest.h>

namespace quadrille::refine {
namespace {

/// Anchors at 0.2, 0.5 and 0.6; the one in the middle is of two arcs.
AnchoredSegments three_anchors() {
  return {{{0.2, {{0.2, 0.25, 0}}}, {0.5, {{0.45, 0.4, 0}, {0.55, 0.6, 1}}}, {0.6, {{0.6, 0.7, 0}}}}, {}, {}};
}

TEST(AnchoredSegments, RequiredAnchorsAreTheInnerEndsInOrder) {
  AnchoredSegments anchored = three_anchors();
  for (const int anchor : {2, 0, 1, 0}) require_anchor(anchored, anchor);
  EXPECT_EQ(anchored.required, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(anchored.segments.ends, (std::vector<double>{0, 0.2, 0.5, 0.6, 1}));
  EXPECT_EQ(anchored.segments.least_counts, (std::vector<int>{1, 1, 1, 1}));
}

TEST(AnchoredSegments, OnlyTheSegmentThatIsCutForgetsItsCount) {
  AnchoredSegments anchored = three_anchors();
  require_anchor(anchored, 1);
  anchored.segments.least_counts = {4, 7};
  require_anchor(anchored, 1);
  EXPECT_EQ(anchored.segments.least_counts, (std::vector<int>{4, 7})) << "it is required already";
  require_anchor(anchored, 0);
  EXPECT_EQ(anchored.segments.least_counts, (std::vector<int>{1, 1, 7}));
}

TEST(AnchoredSegments, MovedBreaksMoveAnchorsAndEnds) {
  AnchoredSegments anchored = three_anchors();
  require_anchor(anchored, 1);
  move_breaks(anchored, [](const Break& b) { return b.fraction; });
  EXPECT_EQ(anchored.anchors[0].u, 0.25);
  EXPECT_EQ(anchored.anchors[1].breaks[0].u, 0.4);
  EXPECT_NEAR(anchored.anchors[1].u, 0.5, 1e-15) << "the mean of its breaks";
  EXPECT_EQ(anchored.segments.ends[1], anchored.anchors[1].u);
}

}  // namespace
}  // namespace quadrille::refine
