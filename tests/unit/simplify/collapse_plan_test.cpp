#include "simplify/collapse_plan.hpp"

#include <gtest/gtest.h>

namespace quadrille::simplify {
namespace {

using graph::FixedSide;
constexpr FixedSide l = FixedSide::left, r = FixedSide::right, o = FixedSide::none;

graph::ChordStrip strip_of(int num_blocks, bool is_closed) {
  graph::ChordStrip strip;
  strip.is_closed = is_closed;
  strip.blocks.resize(num_blocks);
  strip.rungs.resize(num_blocks + (is_closed ? 0 : 1));
  strip.left.resize(num_blocks), strip.right.resize(num_blocks);
  return strip;
}

TEST(CollapsePlan, BetweenNodesOfOneSideItsRailIsKept) {
  const CollapsePlan plan = plan_collapse(strip_of(3, false), {l, o, o, l});
  EXPECT_EQ(plan.kept_rail, (std::vector<FixedSide>{l, l, l}));
  EXPECT_EQ(plan.merged_into, (std::vector<FixedSide>{l, l, l, l}));
  EXPECT_TRUE(plan.stretches.empty());
}

TEST(CollapsePlan, BetweenNodesOfDifferentSidesRailsAreBlended) {
  const CollapsePlan plan = plan_collapse(strip_of(3, false), {l, o, o, r});
  EXPECT_EQ(plan.kept_rail, (std::vector<FixedSide>{o, o, o}));
  EXPECT_EQ(plan.merged_into, (std::vector<FixedSide>{l, o, o, r}));
  ASSERT_EQ(plan.stretches.size(), 1u);
  EXPECT_EQ(plan.stretches[0].first_rung, 0);
  EXPECT_EQ(plan.stretches[0].num_blocks, 3);
  EXPECT_TRUE(plan.stretches[0].from_left);
}

TEST(CollapsePlan, BeforeTheFirstAndBehindTheLastFixedNodeTheRailIsKept) {
  const CollapsePlan plan = plan_collapse(strip_of(4, false), {o, r, l, o, o});
  EXPECT_EQ(plan.kept_rail, (std::vector<FixedSide>{r, o, l, l}));
  EXPECT_EQ(plan.merged_into, (std::vector<FixedSide>{r, r, l, l, l}));
  ASSERT_EQ(plan.stretches.size(), 1u);
  EXPECT_FALSE(plan.stretches[0].from_left);
}

TEST(CollapsePlan, AClosedStripGoesOnAfterItsLastRung) {
  const CollapsePlan plan = plan_collapse(strip_of(3, true), {o, l, r});
  // From rung 1 (left) to 2 (right), and from 2 by 0 to 1.
  ASSERT_EQ(plan.stretches.size(), 2u);
  EXPECT_EQ(plan.stretches[0].first_rung, 1);
  EXPECT_EQ(plan.stretches[1].first_rung, 2);
  EXPECT_EQ(plan.stretches[1].num_blocks, 2);
  EXPECT_EQ(plan.kept_rail, (std::vector<FixedSide>{o, o, o}));
}

TEST(CollapsePlan, AClosedStripFixedOnceKeepsThatRail) {
  const CollapsePlan plan = plan_collapse(strip_of(3, true), {o, l, o});
  EXPECT_EQ(plan.kept_rail, (std::vector<FixedSide>{l, l, l}));
  EXPECT_EQ(plan.merged_into, (std::vector<FixedSide>{l, l, l}));
}

TEST(CollapsePlan, OnlyRailsInsideAreRemoved) {
  ArcGraph graph;
  graph.face.curves.resize(1);
  graph.arcs.resize(2);
  graph.arcs[0].pieces = {{1, 0, 1}};
  graph.arcs[1].pieces = {{0, 0, 1}};
  graph.arcs[1].is_boundary = true;
  graph::ChordStrip strip = strip_of(1, false);
  strip.left[0] = {0}, strip.right[0] = {1};
  EXPECT_TRUE(removes_boundary(graph, strip, plan_collapse(strip, {l, l})));
  EXPECT_FALSE(removes_boundary(graph, strip, plan_collapse(strip, {r, r})));
  EXPECT_TRUE(removes_boundary(graph, strip, plan_collapse(strip, {l, r})));
  graph.arcs[1].is_boundary = false;
  EXPECT_TRUE(removes_boundary(graph, strip, plan_collapse(strip, {l, l}))) << "an interface remains too";
}

}  // namespace
}  // namespace quadrille::simplify
