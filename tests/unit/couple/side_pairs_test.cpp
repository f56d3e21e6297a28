#include "couple/side_pairs.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

using namespace testing_faces;

std::vector<SidePair> sides_of(const CadFace& face) { return interface_sides({face, {}, {}, {}}, CutEnds::included); }

TEST(SidePairs, NodesAreSortedAlongTheFirstSide) {
  const Rectangles two({{{0.2, 0.3}, {0.6, 0.7}}, {{0.5, 0.5}}});
  const std::vector<SidePair> pairs = interface_sides(two.layouts, CutEnds::included);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].curves[0], std::vector<int>{1});
  EXPECT_EQ(pairs[0].curves[1], std::vector<int>{7});
  ASSERT_EQ(pairs[0].nodes[0].size(), 2U) << "without the corners, at the ends of the side";
  EXPECT_NEAR(pairs[0].nodes[0][0].position, 0.3, 1e-12);
  EXPECT_NEAR(pairs[0].nodes[0][1].position, 0.7, 1e-12);
  ASSERT_EQ(pairs[0].nodes[1].size(), 1U);
  const SideNode& other = pairs[0].nodes[1][0];
  EXPECT_NEAR(other.position, 0.5, 1e-12);
  EXPECT_EQ(other.layout, 1);
  EXPECT_TRUE(other.is_movable);
  EXPECT_NEAR(other.line_length, 1, 1e-12);
}

TEST(SidePairs, EndsOfCutsMayBeIgnored) {
  const Rectangles two({{{0.3, 0.3, LineKind::cut}}, {}});
  EXPECT_TRUE(interface_sides(two.layouts, CutEnds::ignored)[0].nodes[0].empty());
  const std::vector<SidePair> pairs = interface_sides(two.layouts, CutEnds::included);
  ASSERT_EQ(pairs[0].nodes[0].size(), 1U);
  EXPECT_TRUE(pairs[0].nodes[0][0].is_cut);
}

TEST(SidePairs, CurvesThatContinueEachOtherOnBothSidesAreOneSide) {
  const std::vector<SidePair> pairs =
      sides_of(face_of_regions({make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {1, 3}, {0, 3}})}),
                                make_face({polygon({{1, 0}, {2, 0}, {2, 3}, {1, 3}, {1, 1}})})}));
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].curves[0], (std::vector<int>{1, 2}));
  EXPECT_EQ(pairs[0].curves[1], (std::vector<int>{9, 8}));
  EXPECT_EQ(pairs[0].offsets, (std::vector<double>{0, 1, 3}));
  EXPECT_FALSE(pairs[0].is_closed);
}

TEST(SidePairs, AJunctionEndsASide) {
  const std::vector<SidePair> pairs =
      sides_of(face_of_regions({make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {1, 2}, {0, 2}})}),
                                rectangle({1, 0}, {2, 1}), rectangle({1, 1}, {2, 2})}));
  EXPECT_EQ(pairs.size(), 3U);
}

TEST(SidePairs, ACircleIsClosed) {
  const std::vector<SidePair> pairs = sides_of(disc_in_square());
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_TRUE(pairs[0].is_closed);
  EXPECT_NEAR(pairs[0].length(), 2 * pi, 1e-9);
  EXPECT_NEAR(pairs[0].distance(0.1, 2 * pi - 0.2), 0.3, 1e-9) << "across the seam";
}

TEST(SidePairs, ANodeOfASecondPeriodicSideIsWhereItsImageIs) {
  const PeriodicSquare square({{0.2, 0.2}});
  const std::vector<SidePair> pairs = periodic_sides(square.layouts);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].curves[0], std::vector<int>{3});
  for (const std::vector<SideNode>& side : pairs[0].nodes) {
    ASSERT_EQ(side.size(), 1U);
    EXPECT_NEAR(side[0].position, 0.8, 1e-12) << "the first side runs downwards";
  }
}

TEST(SidePairs, APointIsFoundOnEitherSide) {
  const Rectangles two({{}, {}});
  const CadFace& face = two.layouts.face;
  const SidePair pair = interface_sides(two.layouts, CutEnds::included).front();
  const BoundaryPoint first = point_at(face, pair, 0.25);
  EXPECT_EQ(first.curve, 1);
  EXPECT_NEAR(first.t, 0.25, 1e-12);
  EXPECT_EQ(point_on_side(face, pair, 0, first), first);
  const BoundaryPoint second = point_on_side(face, pair, 1, first);
  EXPECT_EQ(second.curve, 7);
  EXPECT_NEAR(second.t, 0.75, 1e-12);
  EXPECT_EQ(point_on_side(face, pair, 0, second), first);
  EXPECT_THROW(point_on_side(face, pair, 0, {0, 0.5}), Defect);
}

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
