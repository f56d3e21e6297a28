#include "mesh/chords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../support/block_sides.hpp"

namespace quadrille::mesh {
namespace {

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
