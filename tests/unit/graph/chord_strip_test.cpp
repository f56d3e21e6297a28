#include "graph/chord_strip.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/hall.hpp"

namespace quadrille::graph {
namespace {

constexpr double step = 0.1;

struct Strips : testing::Test {
  const CandidateLayout layout = hall(step);
  const Subdivision& subdivision = layout.subdivision;
  const std::vector<double> lengths = arc_lengths(layout.graph());
};

TEST_F(Strips, OfTheHallAreSix) {
  const auto strips = all_strips(subdivision, lengths);
  EXPECT_EQ(strips.size(), 6u);
  std::size_t blocks = 0;
  for (const ChordStrip& strip : strips) {
    EXPECT_FALSE(strip.is_closed);
    EXPECT_EQ(strip.rungs.size(), strip.blocks.size() + 1);
    blocks += strip.blocks.size();
  }
  EXPECT_EQ(blocks, 12u);  // each in two
}

TEST_F(Strips, RailsAndRungsFollowEachOther) {
  for (const ChordStrip& strip : all_strips(subdivision, lengths))
    for (int b = 0; b < strip.num_blocks(); ++b) {
      EXPECT_EQ(subdivision.start(strip.left[b]), subdivision.start(strip.rungs[b]));
      EXPECT_EQ(subdivision.end(strip.left[b]), subdivision.start(strip.rungs[b + 1]));
      EXPECT_EQ(subdivision.start(strip.right[b]), subdivision.end(strip.rungs[b]));
      EXPECT_EQ(subdivision.end(strip.right[b]), subdivision.end(strip.rungs[b + 1]));
    }
}

TEST_F(Strips, AStripIsTheSameFromEachOfItsRungs) {
  const ChordStrip strip = thin_strip_of_hall(subdivision, step);
  for (const HalfEdge rung : strip.rungs) EXPECT_EQ(strip_through(subdivision, rung.arc).rungs, strip.rungs);
}

TEST_F(Strips, TheThinOneHasAFixedCornerAtEachRung) {
  const ChordStrip strip = thin_strip_of_hall(subdivision, step);
  ASSERT_EQ(strip.num_blocks(), 2);
  EXPECT_NEAR(strip.width, step, 1e-12);
  EXPECT_NEAR(strip.length, 3, 1e-12);
  const std::vector<FixedSide> fixed = fixed_sides(subdivision, strip);
  ASSERT_EQ(fixed.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfEdge rung = strip.rungs[i];
    const int node = fixed[i] == FixedSide::left ? subdivision.start(rung) : subdivision.end(rung);
    EXPECT_EQ(layout.graph().nodes[node].kind, NodeKind::corner);
  }
  // P and the floor's other end on one side, Q on the other.
  EXPECT_NE(std::count(fixed.begin(), fixed.end(), FixedSide::left), 3);
  EXPECT_NE(std::count(fixed.begin(), fixed.end(), FixedSide::right), 3);
}

TEST(ChordStrip, BetweenBoundariesNothingCanBeCollapsed) {
  for (const SeparatrixGraph& graph :
       {hand_made::unit_square(), hand_made::l_shape(), hand_made::quarter_annulus(), hand_made::cut_annulus(4)}) {
    const Subdivision subdivision(graph);
    for (const ChordStrip& strip : all_strips(subdivision, arc_lengths(graph)))
      EXPECT_TRUE(fixed_sides(subdivision, strip).empty());
  }
}

TEST(ChordStrip, AnAnnulusHasOneClosedStrip) {
  const SeparatrixGraph graph = hand_made::cut_annulus(4);
  int closed = 0;
  for (const ChordStrip& strip : all_strips(Subdivision(graph), arc_lengths(graph))) {
    closed += strip.is_closed;
    EXPECT_EQ(strip.rungs.size(), strip.blocks.size() + (strip.is_closed ? 0 : 1));
    EXPECT_FALSE(strip.crosses_itself);
  }
  EXPECT_EQ(closed, 1);
}

TEST(ChordStrip, NodesAreFixedWhereTheyAreIrregularOrCorners) {
  EXPECT_FALSE(is_fixed({{}, NodeKind::crossing, 4, -1, 0}));
  EXPECT_TRUE(is_fixed({{}, NodeKind::irregular, 3, -1, 0}));
  EXPECT_FALSE(is_fixed({{}, NodeKind::boundary, 2, 0, 0.5}));
  EXPECT_TRUE(is_fixed({{}, NodeKind::boundary, 3, 0, 0.5}));
  EXPECT_TRUE(is_fixed({{}, NodeKind::corner, 2, 0, 0}));
}

}  // namespace
}  // namespace quadrille::graph
