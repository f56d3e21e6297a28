#include "couple/match_line_ends.hpp"

#include <gtest/gtest.h>

#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

SideNode node_at(double position, bool is_movable = true, double line_length = 1) {
  return {0, 0, position, is_movable, line_length, false};
}

/// Sides of length 1 with nodes at these positions.
SidePair sides(std::vector<SideNode> firsts, std::vector<SideNode> seconds) {
  SidePair pair;
  pair.curves = {std::vector<int>{0}, std::vector<int>{1}};
  pair.offsets = {0, 1};
  pair.nodes = {std::move(firsts), std::move(seconds)};
  return pair;
}

TEST(MatchesOfNeighbours, NearNodesMatchInTheMiddle) {
  const auto matches = matches_of_neighbours(sides({node_at(0.4)}, {node_at(0.5)}), 1);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_NEAR(matches[0].position, 0.45, 1e-12);
}

TEST(MatchesOfNeighbours, NodesAsFarAsTheNextOneDoNot) {
  EXPECT_TRUE(matches_of_neighbours(sides({node_at(0.2)}, {node_at(0.5)}), 1).empty());
}

TEST(MatchesOfNeighbours, LongLinesMayBeBentFurther) {
  EXPECT_EQ(matches_of_neighbours(sides({node_at(0.2, true, 2)}, {node_at(0.5, true, 2)}), 1).size(), 1U)
      << "each by 0.075 radian";
}

TEST(MatchesOfNeighbours, BetweenTwoEquallyNearNodesThereIsNoChoice) {
  EXPECT_TRUE(matches_of_neighbours(sides({node_at(0.5)}, {node_at(0.45), node_at(0.55)}), 1).empty());
}

TEST(MatchesOfNeighbours, ANodeThatCannotMoveIsThePlace) {
  const auto matches = matches_of_neighbours(sides({node_at(0.4)}, {node_at(0.5, false)}), 1);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].position, 0.5);
  EXPECT_TRUE(matches_of_neighbours(sides({node_at(0.4, false)}, {node_at(0.5, false)}), 1).empty());
}

TEST(MatchesOfNeighbours, NodesInOnePlaceNeedNoMatch) {
  EXPECT_TRUE(matches_of_neighbours(sides({node_at(0.5)}, {node_at(0.5 + 5e-10)}), 1).empty());
}

TEST(MatchesOfNeighbours, TheMiddleMayLieAcrossTheSeam) {
  SidePair pair = sides({node_at(0.02)}, {node_at(0.92)});
  pair.is_closed = true;
  const auto matches = matches_of_neighbours(pair, 1);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_NEAR(matches[0].position, 0.97, 1e-12);
}

TEST(MatchLineEnds, BendsBothLinesToTheirPlace) {
  Rectangles two({{{0.5, 0.5}}, {{0.56, 0.56}}});
  EXPECT_EQ(match_line_ends(two.layouts, interface_sides(two.layouts, CutEnds::included)), 1);
  for (const int region : {0, 1}) {
    EXPECT_TRUE(two.has_node(region, {1, 0.53}));
    const graph::CandidateLayout& layout = two.layouts.layouts[region];
    ASSERT_EQ(layout.lines.size(), 1U);
    EXPECT_EQ(layout.lines[0].kind, LineKind::merged);
    EXPECT_EQ(layout.graph().splines.size(), 1U) << "the former line is removed";
    EXPECT_GT(layout.certificate.largest_deviation_degrees, 1);
  }
}

TEST(MatchLineEnds, MovesTheEndsOfPeriodicSidesToImagesOfEachOther) {
  PeriodicSquare square({{0.5, 0.56}});
  EXPECT_EQ(match_line_ends(square.layouts, periodic_sides(square.layouts)), 1);
  EXPECT_TRUE(square.has_node(0, {0, 0.53}));
  EXPECT_TRUE(square.has_node(0, {1, 0.53}));
}

TEST(MatchLineEnds, WithoutSidesNothingChanges) {
  Rectangles one({{{0.5, 0.5}}});
  EXPECT_EQ(match_line_ends(one.layouts, interface_sides(one.layouts, CutEnds::included)), 0);
  EXPECT_EQ(one.layouts.layouts[0].lines[0].kind, LineKind::traced);
}

}  // namespace
}  // namespace quadrille::couple
