#include "simplify/chord_collapse.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/hall.hpp"
#include "../support/square_field.hpp"
#include "graph/candidate_layout.hpp"

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

constexpr double step = 0.1;

struct Collapse : testing::Test {
  Field field = interpolated_field(square_mesh({-1, -2}, 6, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  graph::Subdivision subdivision = hall(step).subdivision;
  graph::ChordStrip strip = thin_strip_of_hall(subdivision, step);
  std::vector<Blend> blends = blends_of(evaluator, subdivision, strip, {1, 1e-9}).value();
};

TEST_F(Collapse, TheStripIsGoneAndEveryFaceHasFourCorners) {
  const int num_faces = subdivision.num_faces(), num_arcs = subdivision.arc_bound();
  const auto changes = collapse_strip(subdivision, strip, blends);
  ASSERT_TRUE(changes);
  subdivision.compact();
  EXPECT_EQ(subdivision.num_faces(), num_faces - strip.num_blocks());
  EXPECT_EQ(subdivision.arc_bound(), num_arcs - 3 - 2);  // three rungs, one rail of two blocks
  EXPECT_TRUE(graph::faces_without_four_corners(subdivision).empty());
  for (int n = 0; n < subdivision.node_bound(); ++n) EXPECT_TRUE(graph::is_drawn_in_order(subdivision, n));
  const graph::Subdivision built(subdivision.graph());
  for (int f = 0; f < built.face_bound(); ++f) EXPECT_EQ(subdivision.cycle(f), built.cycle(f));
}

TEST_F(Collapse, ArcsAreFollowedAndChangesMarked) {
  const ArcGraph before = subdivision.graph();
  const auto changes = collapse_strip(subdivision, strip, blends);
  ASSERT_TRUE(changes);
  for (const HalfEdge rung : strip.rungs) EXPECT_EQ(changes->now(rung.arc), -1);
  for (int b = 0; b < strip.num_blocks(); ++b)
    EXPECT_EQ(changes->now(strip.left[b].arc), changes->now(strip.right[b].arc));
  const auto same = [](const ArcPiece& p, const ArcPiece& q) {
    return p.curve == q.curve && p.t0 == q.t0 && p.t1 == q.t1;
  };
  for (std::size_t a = 0; a < before.arcs.size(); ++a) {
    const int now = changes->now(static_cast<int>(a));
    if (now < 0 || changes->changed.contains(now)) continue;
    const auto &p = before.arcs[a].pieces, &q = subdivision.graph().arcs[now].pieces;
    if (std::none_of(strip.left.begin(), strip.left.end(), [&](HalfEdge h) { return h.arc == static_cast<int>(a); }) &&
        std::none_of(strip.right.begin(), strip.right.end(),
                     [&](HalfEdge h) { return h.arc == static_cast<int>(a); })) {
      EXPECT_TRUE(std::equal(p.begin(), p.end(), q.begin(), q.end(), same)) << a;
    }
  }
}

TEST_F(Collapse, WithoutItsBlendNothingIsChanged) {
  const graph::Subdivision before = subdivision;
  EXPECT_FALSE(collapse_strip(subdivision, strip, {}));
  EXPECT_EQ(subdivision.num_faces(), before.num_faces());
  EXPECT_EQ(subdivision.graph().splines.size(), before.graph().splines.size());
  for (int f = 0; f < before.face_bound(); ++f) EXPECT_EQ(subdivision.cycle(f), before.cycle(f));
}

TEST_F(Collapse, ABlendThatDeviatesTooFarIsNone) {
  EXPECT_FALSE(blends_of(evaluator, subdivision, strip, {0.9 * deviation_of_hall(step), 1e-9}));
}

}  // namespace
}  // namespace quadrille::simplify
