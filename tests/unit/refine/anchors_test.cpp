#include "refine/anchors.hpp"

#include <gtest/gtest.h>

namespace quadrille::refine {
namespace {

TEST(Anchors, FacingBreaksShareOne) {
  const std::vector<Anchor> anchors = find_anchors({{0.52, 0.5, 1}, {0.2, 0.2, 0}, {0.5, 0.5, 0}}, 0.05);
  ASSERT_EQ(anchors.size(), 2u);
  EXPECT_EQ(anchors[0].u, 0.2);
  EXPECT_NEAR(anchors[1].u, 0.51, 1e-15);
  EXPECT_EQ(anchors[1].breaks.size(), 2u);
}

TEST(Anchors, BreaksOutOfReachStandAlone) { EXPECT_EQ(find_anchors({{0.2, 0.2, 0}, {0.3, 0.3, 1}}, 0.05).size(), 2u); }

TEST(Anchors, BreaksOfOneArcAreNeverJoined) {
  // A fillet on each of two facing arcs, both ends within reach of each other: end joins end.
  const std::vector<Anchor> anchors =
      find_anchors({{0.500, 0.5, 0}, {0.510, 0.51, 0}, {0.501, 0.5, 1}, {0.511, 0.51, 1}}, 0.1);
  ASSERT_EQ(anchors.size(), 2u);
  for (const Anchor& a : anchors) {
    ASSERT_EQ(a.breaks.size(), 2u);
    EXPECT_NE(a.breaks[0].arc, a.breaks[1].arc);
  }
  EXPECT_LT(anchors[0].u, anchors[1].u);
}

TEST(Anchors, NoneWithoutBreaks) { EXPECT_TRUE(find_anchors({}, 0.1).empty()); }

}  // namespace
}  // namespace quadrille::refine
