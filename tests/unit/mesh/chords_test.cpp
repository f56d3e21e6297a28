#include "mesh/chords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "../hand_made.hpp"
#include "../samples.hpp"
#include "../support/block_sides.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::mesh {

namespace {

BlockLayout blocks(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

/// The boundary side on this CAD curve.
BlockSide side_on(const BlockLayout& layout, int curve) {
  for (int block = 0; block < layout.num_blocks(); ++block)
    for (int side = 0; side < 4; ++side) {
      const GraphArc& arc = layout.arcs[half_edge(layout, block, side).arc];
      if (arc.is_boundary && arc.pieces[0].curve == curve) return {block, side};
    }
  return {};
}

TEST(BlockSides, ContinueEachOtherAtValenceTwoOnly) {
  const BlockLayout row = blocks(hand_made::row({1, 1, 1}));
  const ArcSides sides = sides_of_arcs(row);
  const BlockSide middle = side_on(row, 1), left = side_on(row, 0), right = side_on(row, 2);
  EXPECT_EQ(next_along_boundary(row, sides, middle, 1).block, right.block);
  EXPECT_EQ(next_along_boundary(row, sides, middle, 1).side, right.side);
  EXPECT_EQ(next_along_boundary(row, sides, middle, -1).block, left.block);
  EXPECT_EQ(next_along_boundary(row, sides, left, -1).block, -1) << "V = 1";
  const BlockLayout reflex = blocks(hand_made::l_shape());
  EXPECT_EQ(next_along_boundary(reflex, sides_of_arcs(reflex), side_on(reflex, 2), 1).block, -1) << "V = 3";
}

TEST(BlockSides, OfARingOfOneBlockContinueThemselves) {
  const BlockLayout ring = blocks(hand_made::cut_annulus(1));
  const ArcSides sides = sides_of_arcs(ring);
  for (const int curve : {0, 1})
    for (const int step : {-1, 1}) {
      const BlockSide side = side_on(ring, curve), next = next_along_boundary(ring, sides, side, step);
      EXPECT_EQ(next.block, side.block);
      EXPECT_EQ(next.side, side.side);
    }
}

TEST(BlockSides, HalfEdgesBeginWhereTheOppositeOnesEnd) {
  const ArcEnd from = beginning({3, false}), to = ending({3, false});
  EXPECT_EQ(from.arc, 3);
  EXPECT_EQ(from.end, 0);
  EXPECT_EQ(to.end, 1);
  EXPECT_EQ(beginning({3, true}).end, to.end);
  EXPECT_EQ(ending({3, true}).end, from.end);
}

using End = std::pair<int, int>;  // arc and end

End of(const ArcEnd& end) { return {end.arc, end.end}; }

TEST(ArcNeighbours, AreOnBothSidesOfTheArcBetweenTwoBlocks) {
  // Arc 6 lies between both blocks: arcs 0 and 1 meet at its begin, 3 and 4 at its end.
  const std::vector<ArcNeighbours> pairs = arc_neighbours(samples::block_layout());
  ASSERT_EQ(pairs.size(), 2u);
  std::set<std::set<End>> met;
  for (const ArcNeighbours& pair : pairs) met.insert({of(pair.a), of(pair.b)});
  EXPECT_EQ(met, (std::set<std::set<End>>{{{0, 1}, {1, 0}}, {{4, 0}, {3, 1}}}));
}

TEST(ArcNeighbours, OneBlockHasNone) {
  BlockLayout layout = samples::block_layout();
  layout.block2arcs = {block_sides({0, 6, 4, 5})};
  layout.block2nodes.resize(1);
  EXPECT_TRUE(arc_neighbours(layout).empty());
}

TEST(ArcNeighbours, ABlockThatMeetsItselfHasNone) {
  // A ring of one block: its sides 1 and 3 are one arc.
  BlockLayout layout = samples::block_layout();
  layout.block2nodes.resize(1);
  layout.block2arcs = {block_sides({0, 6, 4, -7})};
  EXPECT_TRUE(arc_neighbours(layout).empty());
}

TEST(ArcNeighbours, NeighboursMeetAtOneNode) {
  const BlockLayout layout = samples::block_layout();
  const auto node = [&](const ArcEnd& end) {
    return end.end == 0 ? layout.arcs[end.arc].from : layout.arcs[end.arc].to;
  };
  for (const ArcNeighbours& pair : arc_neighbours(layout)) EXPECT_EQ(node(pair.a), node(pair.b));
}

TEST(Chords, NumberedByTheirFirstArc) {
  EXPECT_EQ(arc_chords({block_sides({0, 1, 2, 3})}, 5), (std::vector<int>{0, 1, 0, 1, 2}));
  // Two blocks side by side share arc 1; the second walks it backwards.
  EXPECT_EQ(arc_chords({block_sides({0, 1, 2, 3}), block_sides({4, 5, 6, -2})}, 7),
            (std::vector<int>{0, 1, 0, 1, 2, 1, 2}));
}

TEST(Chords, AChordMayCrossItself) {
  EXPECT_EQ(arc_chords({block_sides({0, 1, 2, 3}), block_sides({2, 4, 1, 5})}, 6),
            (std::vector<int>{0, 0, 0, 0, 1, 1}));
}

TEST(Chords, ArcsOfAChordRunOneWay) {
  // Two unit squares side by side, bottoms 0 and 4, tops 2 and 6 walked counter-clockwise; arc 1 is shared.
  const std::vector<std::array<HalfEdge, 4>> block2arcs{block_sides({0, 1, 2, 3}), block_sides({4, 5, 6, -2})};
  const std::vector<Chord> chords = directed_chords(block2arcs, arc_chords(block2arcs, 7));
  ASSERT_EQ(chords.size(), 3u);
  EXPECT_EQ(chords[0].arcs, (std::vector<int>{0, 2}));
  EXPECT_EQ(chords[0].backwards, (std::vector<bool>{false, true}));
  EXPECT_EQ(chords[0].pairs, (std::vector<std::array<int, 2>>{{0, 1}}));
  // Right sides run up, the left one of the first block runs down.
  EXPECT_EQ(chords[1].arcs, (std::vector<int>{1, 3, 5}));
  EXPECT_EQ(chords[1].backwards, (std::vector<bool>{false, true, false}));
}

TEST(Chords, ABlockThatTouchesItselfIsNoPair) {
  const std::vector<std::array<HalfEdge, 4>> block2arcs{block_sides({0, 2, 1, -3})};
  const std::vector<Chord> chords = directed_chords(block2arcs, arc_chords(block2arcs, 3));
  ASSERT_EQ(chords.size(), 2u);
  EXPECT_EQ(chords[0].pairs.size(), 1u);
  EXPECT_TRUE(chords[1].pairs.empty());
}

}  // namespace

}  // namespace quadrille::mesh
