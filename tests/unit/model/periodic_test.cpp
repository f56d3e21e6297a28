#include "model/periodic.hpp"

#include <gtest/gtest.h>

#include "../support/grid_layout.hpp"

namespace quadrille {
namespace {

/// [0, 3] x [0, 2] in unit squares, the right side periodic with the left one.
SeparatrixGraph periodic_grid() {
  SeparatrixGraph g = grid_layout(3, 2);
  g.face.curve_names = {"low", "right", "high", "left"};
  g.face.periodic_pairs = {{{1, 3}, 0, {-3, 0}}};
  return g;
}

Vec2 start(const ArcGraph& graph, int arc) { return graph.nodes[graph.arcs[arc].from].position; }

TEST(PeriodicArcs, TheSecondIsTheImageOfTheFirstBackwards) {
  const SeparatrixGraph graph = periodic_grid();
  const std::vector<PeriodicArcs> pairs = periodic_arcs(graph);
  ASSERT_EQ(pairs.size(), 2u);
  for (const auto& [first, second] : pairs) {
    EXPECT_EQ(start(graph, first.arc).x, 3);
    EXPECT_EQ(start(graph, second.arc).x, 0);
    EXPECT_EQ(start(graph, second.arc).y, start(graph, first.arc).y + 1);
    EXPECT_FALSE(first.is_backwards || second.is_backwards);
    EXPECT_EQ(first_arcs(graph)[second.arc], first.reversed());
    EXPECT_EQ(first_arcs(graph)[first.arc], first);
  }
  EXPECT_EQ(matched_arcs(graph), pairs);
  EXPECT_NO_THROW(require_periodic_arcs(graph, ""));
}

TEST(PeriodicArcs, AnArcWithoutCounterpartIsLeftOutAndRefused) {
  SeparatrixGraph graph = periodic_grid();
  for (GraphArc& arc : graph.arcs)  // the node at (0, 1) half a unit higher
    for (ArcPiece& piece : arc.pieces)
      if (piece.curve == 3) (piece.t0 == 1 ? piece.t0 : piece.t1) -= 0.5;
  EXPECT_TRUE(periodic_arcs(graph).empty());
  try {
    require_periodic_arcs(graph, "make it again");
    FAIL() << "accepted";
  } catch (const ComputeError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "the blocks along the periodic curves 'right' and 'left' do not match: the side from (3, 0) to (3, 1) has no "
        "counterpart; make it again");
  }
}

TEST(PeriodicArcs, BothSidesOfACrackMatch) {
  SeparatrixGraph graph = periodic_grid();
  graph.face.periodic_pairs.clear();
  graph.face.partners = {-1, 3, -1, 1};  // as if both sides were one slit
  EXPECT_TRUE(periodic_arcs(graph).empty());
  EXPECT_EQ(matched_arcs(graph).size(), 2u);
}

}  // namespace
}  // namespace quadrille
