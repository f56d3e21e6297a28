#include "prescribe/named_arcs.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "../region_layout_samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::prescribe {
namespace {

/// Three blocks of width 1; the top is curve 4, from the right.
BlockLayout three_blocks() { return block::extract_blocks(hand_made::row({1, 1, 1})); }

/// Ends of the arcs of a name, in their direction.
std::vector<std::pair<Vec2, Vec2>> ends(const BlockLayout& layout, const std::string& name) {
  const sizing::MeasuredLayout measured(layout);
  std::vector<std::pair<Vec2, Vec2>> found;
  for (const HalfEdge& edge : named_arcs(measured, name, "--count")) {
    Vec2 from = layout.nodes[layout.arcs[edge.arc].from].position, to = layout.nodes[layout.arcs[edge.arc].to].position;
    if (edge.is_backwards) std::swap(from, to);
    found.emplace_back(from, to);
  }
  return found;
}

using Ends = std::vector<std::pair<Vec2, Vec2>>;

TEST(NamedArcs, FollowTheCurveWithTheFaceOnTheirLeft) {
  EXPECT_EQ(ends(three_blocks(), "side_4"), (Ends{{{3, 1}, {2, 1}}, {{2, 1}, {1, 1}}, {{1, 1}, {0, 1}}}));
}

TEST(NamedArcs, TheDirectionOfAnArcDoesNotMatter) {
  BlockLayout layout = three_blocks();
  for (GraphArc& arc : layout.arcs) {
    if (arc.pieces.front().curve != 4 || !arc.is_boundary) continue;
    std::swap(arc.from, arc.to);
    for (ArcPiece& piece : arc.pieces) std::swap(piece.t0, piece.t1);
  }
  EXPECT_EQ(ends(layout, "side_4"), (Ends{{{3, 1}, {2, 1}}, {{2, 1}, {1, 1}}, {{1, 1}, {0, 1}}}));
}

TEST(NamedArcs, CurvesOfOneNameComeByTheirNumbers) {
  BlockLayout layout = three_blocks();
  layout.face.curve_names[2] = layout.face.curve_names[0] = "ground";
  EXPECT_EQ(ends(layout, "ground"), (Ends{{{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}}));
}

TEST(NamedArcs, ANameThatNoCurveHasIsRefused) {
  const BlockLayout layout = three_blocks();
  expect_contains(message_of<UsageError>([&] { ends(layout, "nowhere"); }),
                  "--count: there is no boundary \"nowhere\"");
}

/// The side of the one block over both lower sides of the elbow.
TEST(NamedArcs, ASideThatGoesOnBeyondTheBoundaryIsRefused) {
  SeparatrixGraph graph = hand_made::row({1});
  graph.face = hand_made::row({0.5, 0.5}).face;  // the lower side consists of two curves
  graph.arcs[0].pieces = {{0, 0, 0.5}, {1, 0, 0.5}};
  for (std::size_t a = 1; a < graph.arcs.size(); ++a)
    for (ArcPiece& piece : graph.arcs[a].pieces) ++piece.curve;
  for (GraphNode& node : graph.nodes)
    if (node.curve > 0) ++node.curve;
  const BlockLayout layout = block::extract_blocks(graph);
  const std::string message = message_of<UsageError>([&] { ends(layout, "side_0"); });
  EXPECT_TRUE(
      message.starts_with("--count: the side of a block through (0.5, 0) follows the boundary 'side_0' in part "
                          "only: use the number of its chord, "))
      << message;
}

TEST(NamedArcs, AnInterfaceIsOneArcAndAnOpenOneTwo) {
  EXPECT_EQ(ends(samples::two_regions_layout(), "fluid-solid").size(), 1u);
  const BlockLayout open = samples::open_regions_layout();
  EXPECT_EQ(ends(open, "fluid-solid").size(), 2u);
  EXPECT_EQ(ends(open, "fluid-solid@solid"), (Ends{{{1, 1}, {1, 0}}}));
}

}  // namespace
}  // namespace quadrille::prescribe
