#include "quantize/split_arcs.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::quantize {
namespace {

// The unit square. Arc 0 is its floor and its right side, arc 1 the rest, arc 2 a line from (0, 0) to (1, 1).
struct SplitSquare : testing::Test {
  SeparatrixGraph graph = hand_made::unit_square();
  ArcGraph whole;  ///< with split arcs
  ArcParts parts;

  void make(const CrossingFractions& fractions) {
    graph.arcs.clear();
    graph.nodes = {graph.nodes[0], graph.nodes[2]};
    for (GraphNode& node : graph.nodes) node.valence = 2;
    hand_made::add_arc(graph, 0, 1, true, {{0, 0, 1}, {1, 0, 1}});
    hand_made::add_arc(graph, 1, 0, true, {{2, 0, 1}, {3, 0, 1}});
    hand_made::add_cut(graph, 0, 1);
    const curve::CurveTable table(graph.face, graph.splines);
    std::vector<curve::Chain> chains;
    for (const GraphArc& arc : graph.arcs) chains.emplace_back(table, arc.pieces);
    graph::Subdivision subdivision(graph);
    parts = split_arcs(chains, fractions, subdivision);
    whole = subdivision.graph();
  }
  const GraphArc& part(int arc, int k) const { return whole.arcs[parts[arc][k]]; }

  static void expect_piece(const ArcPiece& piece, int curve, double t0, double t1) {
    EXPECT_EQ(piece.curve, curve);
    EXPECT_NEAR(piece.t0, t0, 1e-12);
    EXPECT_NEAR(piece.t1, t1, 1e-12);
  }
};

TEST_F(SplitSquare, WithoutCrossingsEveryArcIsOnePart) {
  make({{}, {}, {}});
  ASSERT_EQ(whole.arcs.size(), 3u);
  EXPECT_EQ(whole.nodes.size(), 2u);
  for (int a = 0; a < 3; ++a) {
    ASSERT_EQ(parts[a].size(), 1u);
    EXPECT_EQ(part(a, 0).from, graph.arcs[a].from);
    EXPECT_EQ(part(a, 0).to, graph.arcs[a].to);
    EXPECT_EQ(part(a, 0).is_boundary, a < 2);
    EXPECT_EQ(part(a, 0).pieces.size(), graph.arcs[a].pieces.size());
  }
}

TEST_F(SplitSquare, ABoundaryArcIsCutInsideItsPieces) {
  make({{{1, 0.25}, {4, 0.75}}, {}, {}});
  ASSERT_EQ(parts[0].size(), 3u);
  expect_piece(part(0, 0).pieces.at(0), 0, 0, 0.5);
  ASSERT_EQ(part(0, 1).pieces.size(), 2u);
  expect_piece(part(0, 1).pieces[0], 0, 0.5, 1);
  expect_piece(part(0, 1).pieces[1], 1, 0, 0.5);
  ASSERT_EQ(part(0, 2).pieces.size(), 1u);
  expect_piece(part(0, 2).pieces[0], 1, 0.5, 1);
  const int second = part(0, 1).to;
  EXPECT_EQ(part(0, 1).from, part(0, 0).to);
  EXPECT_EQ(part(0, 2).from, second);
  EXPECT_EQ(part(0, 0).from, 0);
  EXPECT_EQ(part(0, 2).to, 1);
  const GraphNode& node = whole.nodes[second];
  EXPECT_EQ(node.kind, NodeKind::boundary);
  EXPECT_EQ(node.valence, 2);
  EXPECT_EQ(node.curve, 1);
  EXPECT_NEAR(distance(node.position, {1, 0.5}), 0, 1e-12);
}

TEST_F(SplitSquare, TwoCrossingsMayLieOnOnePiece) {
  make({{{1, 0.1}, {2, 0.2}}, {}, {}});
  ASSERT_EQ(parts[0].size(), 3u);
  ASSERT_EQ(part(0, 1).pieces.size(), 1u);
  expect_piece(part(0, 1).pieces[0], 0, 0.2, 0.4);
  EXPECT_EQ(part(0, 2).pieces.size(), 2u);
}

TEST_F(SplitSquare, ACutAtAJointLeavesNoPieceOfNoLength) {
  make({{{1, 0.5}}, {}, {}});
  ASSERT_EQ(parts[0].size(), 2u);
  for (const int k : {0, 1}) {
    ASSERT_EQ(part(0, k).pieces.size(), 1u);
    expect_piece(part(0, k).pieces[0], k, 0, 1);
  }
}

TEST_F(SplitSquare, ALineInsideGetsRegularNodes) {
  make({{}, {}, {{2, 0.5}}});
  ASSERT_EQ(parts[2].size(), 2u);
  const GraphNode& node = whole.nodes[part(2, 0).to];
  EXPECT_EQ(node.kind, NodeKind::crossing);
  EXPECT_EQ(node.valence, 4);
  EXPECT_EQ(node.curve, -1);
  EXPECT_NEAR(distance(node.position, {0.5, 0.5}), 0, 1e-12);
}

}  // namespace
}  // namespace quadrille::quantize
