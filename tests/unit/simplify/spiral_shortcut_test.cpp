#include "simplify/spiral_shortcut.hpp"

#include <gtest/gtest.h>

#include "../support/grid_layout.hpp"
#include "../support/hall.hpp"
#include "../support/snail.hpp"
#include "../support/square_field.hpp"
#include "curve/nurbs.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::simplify {
namespace {

/// Crosses along the circles about the origin.
Field field_of_circles() {
  return interpolated_field(square_mesh({-3, -3}, 6, 6), 4, [](Vec2 x) {
    const Vec2 z2{x.x * x.x - x.y * x.y, 2 * x.x * x.y};
    return Vec2{z2.x * z2.x - z2.y * z2.y, 2 * z2.x * z2.y};
  });
}

struct Snail : testing::Test {
  Field field = field_of_circles();
  field::FieldEvaluator evaluator{field};
  graph::Subdivision subdivision = snail::layout().subdivision;
  BlendOptions options{1, 1e-9};

  void cut_the_strip() { subdivision = snail::layout(true).subdivision; }
  std::vector<SpiralShortcut> shortcuts() const {
    return find_shortcuts(subdivision, graph::arc_lengths(subdivision.graph()));
  }
  Vec2 start(HalfEdge h) const { return subdivision.graph().nodes[subdivision.start(h)].position; }
  Vec2 end(HalfEdge h) const { return subdivision.graph().nodes[subdivision.end(h)].position; }
};

TEST_F(Snail, TheStripBetweenBothEndsOfTheLineIsAShortcut) {
  const std::vector<SpiralShortcut> found = shortcuts();
  ASSERT_EQ(found.size(), 1u);
  const SpiralShortcut& s = found[0];
  EXPECT_EQ(s.spline, 0);
  ASSERT_EQ(s.rungs.size(), 2u);
  ASSERT_EQ(s.left.size(), 1u);
  // From P to Q or from Q to P.
  const Vec2 from = s.from_left ? start(s.rungs[0]) : end(s.rungs[0]);
  const Vec2 to = s.from_left ? end(s.rungs[1]) : start(s.rungs[1]);
  const Vec2 p = snail::at(snail::p_laps), q = snail::at(snail::q_laps);
  EXPECT_LT(std::min(distance(from, p) + distance(to, q), distance(from, q) + distance(to, p)), 1e-9);
  // Half a pitch wide, a sixth of a lap long.
  EXPECT_NEAR(s.aspect, 0.5 / (2 * pi / 6 * 1.79), 0.01);
}

TEST_F(Snail, ALineThatPassesNoEndOfItsOwnHasNone) {
  const auto num_shortcuts = [](const ArcGraph& graph) {
    const graph::Subdivision other(graph);
    return find_shortcuts(other, graph::arc_lengths(other.graph())).size();
  };
  EXPECT_EQ(num_shortcuts(hall(0.1).graph()), 0u);  // two lines side by side
  EXPECT_EQ(num_shortcuts(grid_layout(3, 2)), 0u);
  EXPECT_EQ(num_shortcuts(hand_made::cut_annulus(3)), 0u);
}

TEST_F(Snail, TheBlendLeadsFromOneNodeToTheOther) {
  const SpiralShortcut s = shortcuts().at(0);
  const auto blend = blend_of(evaluator, subdivision.graph(), s, options);
  ASSERT_TRUE(blend);
  EXPECT_NEAR(blend->deviation, snail::deviation_at_middle(), 0.02);
  const Vec2 a = curve::point(blend->spline, blend->spline.begin()),
             b = curve::point(blend->spline, blend->spline.end());
  const Vec2 p = snail::at(snail::p_laps), q = snail::at(snail::q_laps);
  EXPECT_LT(std::min(distance(a, p) + distance(b, q), distance(a, q) + distance(b, p)), 1e-8);
  options.max_deviation = 0.9 * blend->deviation;
  EXPECT_FALSE(blend_of(evaluator, subdivision.graph(), s, options));
}

TEST_F(Snail, WithTheShortcutTheLapIsGone) {
  ASSERT_EQ(subdivision.num_faces(), 5);
  const SpiralShortcut s = shortcuts().at(0);
  const auto result = with_shortcut(subdivision, s, blend_of(evaluator, subdivision.graph(), s, options).value());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->num_faces(), 3);
  EXPECT_TRUE(graph::faces_without_four_corners(*result).empty());
  for (int n = 0; n < result->node_bound(); ++n) EXPECT_TRUE(graph::is_drawn_in_order(*result, n)) << n;
  // The crossings with the lines of P and Q are no nodes any more.
  for (const GraphNode& node : result->graph().nodes) EXPECT_NE(node.kind, NodeKind::crossing);
}

TEST_F(Snail, ALineAcrossTheStripIsCrossedOnceInsteadOfTwice) {
  cut_the_strip();
  ASSERT_EQ(subdivision.num_faces(), 8);
  const SpiralShortcut s = shortcuts().at(0);
  ASSERT_EQ(s.rungs.size(), 3u);
  const auto result = with_shortcut(subdivision, s, blend_of(evaluator, subdivision.graph(), s, options).value());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->num_faces(), 5);
  EXPECT_TRUE(graph::faces_without_four_corners(*result).empty());
  int num_crossings = 0;
  for (const GraphNode& node : result->graph().nodes)
    if (node.kind == NodeKind::crossing) {
      ++num_crossings;
      EXPECT_NEAR(angle_of(node.position), pi / 6, 1e-8);
      EXPECT_NEAR(norm(node.position), 1.79, 0.02);
    }
  EXPECT_EQ(num_crossings, 1);
}

TEST_F(Snail, ABlendThatMissesTheRungsDoesNotFit) {
  cut_the_strip();
  const SpiralShortcut s = shortcuts().at(0);
  Blend blend = blend_of(evaluator, subdivision.graph(), s, options).value();
  blend.spline = curve::segment(snail::at(snail::p_laps), {0, -1});
  EXPECT_FALSE(with_shortcut(subdivision, s, blend));
}

}  // namespace
}  // namespace quadrille::simplify
