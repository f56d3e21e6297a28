#include "graph/arc_pieces.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::graph {
namespace {

TEST(ArcPieces, AreJoinedWhereACurveGoesOnAndCutAgain) {
  const Pieces whole = joined({{3, 0, 1}}, {{3, 1, 2}, {4, 5, 4}});
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[0].t1, 2);
  const Pieces back = reversed_pieces(whole);
  EXPECT_EQ(back[0].curve, 4);
  EXPECT_EQ(back[0].t0, 4);
  EXPECT_EQ(joined({{3, 0, 1}}, {{3, 1, 0}}).size(), 2u);  // there and back is not on
  const auto [before, behind] = cut(whole, {{}, {}, 1, 4.5});
  ASSERT_EQ(before.size(), 2u);
  EXPECT_EQ(before[1].t1, 4.5);
  ASSERT_EQ(behind.size(), 1u);
  EXPECT_EQ(behind[0].t0, 4.5);
}

// The unit square with a bottom of two curves that meet at x = 0.5: one arc of two pieces.
SeparatrixGraph with_joint() {
  return hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {0.5, 0}), curve::segment({0.5, 0}, {1, 0}),
                                                curve::segment({1, 0}, {1, 1}), curve::segment({1, 1}, {0, 1}),
                                                curve::segment({0, 1}, {0, 0})}},
                                              std::sqrt(2.0)),
                              {{0, 1}, {2}, {3}, {4}});
}

Subdivision::Division divided_at(Subdivision& subdivision, HalfEdge h, double fraction) {
  const curve::CurveTable table(subdivision.graph().face, subdivision.graph().splines);
  const curve::Chain chain(table, pieces_along(subdivision.graph(), h));
  return divide_at_point(subdivision, h, chain.at(fraction));
}

TEST(DivideAtPoint, TheNodeLiesOnTheBoundaryAndBothPartsEndThere) {
  Subdivision subdivision(with_joint());
  const Subdivision::Division d = divided_at(subdivision, {0}, 0.25);
  const GraphNode& node = subdivision.graph().nodes[d.node];
  EXPECT_EQ(node.kind, NodeKind::boundary);
  EXPECT_EQ(node.curve, 0);
  EXPECT_NEAR(node.t, 0.25, 1e-12);
  EXPECT_EQ(subdivision.graph().arcs[d.first.arc].pieces.size(), 1u);
  EXPECT_EQ(subdivision.graph().arcs[d.second.arc].pieces.size(), 2u);
  EXPECT_EQ(subdivision.graph().arcs[d.second.arc].pieces.front().t0, node.t);
}

TEST(DivideAtPoint, APointAtAJointLeavesNoPieceOfLengthZero) {
  for (const double offset : {-1e-11, 0.0, 1e-11}) {
    Subdivision subdivision(with_joint());
    const Subdivision::Division d = divided_at(subdivision, {0}, 0.5 + offset);
    EXPECT_EQ(subdivision.graph().nodes[d.node].curve, 1);
    EXPECT_EQ(subdivision.graph().nodes[d.node].t, 0);
    for (const HalfEdge h : {d.first, d.second}) {
      ASSERT_EQ(subdivision.graph().arcs[h.arc].pieces.size(), 1u);
      const ArcPiece& piece = subdivision.graph().arcs[h.arc].pieces.front();
      EXPECT_EQ(piece.t0, 0);
      EXPECT_EQ(piece.t1, 0.5);
    }
  }
}

TEST(DivideAtPoint, AnInnerArcIsDividedAtACrossingInEitherDirection) {
  for (const bool is_backwards : {false, true}) {
    Subdivision subdivision(hand_made::l_shape());
    int inner = 0;
    while (subdivision.graph().arcs[inner].is_boundary) ++inner;
    const HalfEdge h{inner, is_backwards};
    const int start = subdivision.start(h), end = subdivision.end(h);
    const Subdivision::Division d = divided_at(subdivision, h, 0.25);
    EXPECT_EQ(subdivision.graph().nodes[d.node].kind, NodeKind::crossing);
    EXPECT_EQ(subdivision.start(d.first), start);
    EXPECT_EQ(subdivision.end(d.first), d.node);
    EXPECT_EQ(subdivision.end(d.second), end);
    EXPECT_EQ((is_backwards ? d.second : d.first).arc, inner);
    const Vec2 from = subdivision.graph().nodes[start].position, at = subdivision.graph().nodes[d.node].position;
    EXPECT_NEAR(distance(from, at), 0.25, 1e-12);
  }
}

}  // namespace
}  // namespace quadrille::graph
