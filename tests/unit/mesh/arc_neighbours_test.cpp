#include "mesh/arc_neighbours.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../samples.hpp"

namespace quadrille::mesh {
namespace {

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

}  // namespace
}  // namespace quadrille::mesh
