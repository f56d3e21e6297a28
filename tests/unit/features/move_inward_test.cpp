#include "features/move_inward.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

/// Moves the first nodes, one from each start along each direction; the others stay.
FeatureState moved(const CadFace& face, double size, const std::vector<FeatureNode>& nodes,
                   const std::vector<Vec2>& directions) {
  FeatureState state = state_of(face, size, nodes);
  std::vector<InwardMove> moves;
  for (size_t i = 0; i < directions.size(); ++i)
    moves.push_back({static_cast<int>(i), nodes[i].position, normalized(directions[i]), 0.1});
  move_inward(state, BoundaryClearance(face), moves);
  expect_sound_changes(state.changes);
  return state;
}

TEST(MoveInward, StopsAtTheSize) {
  const FeatureState state = moved(plate(2), 0.5, {inner_node({-1.9, -1.9}, 3)}, {{1, 1}});
  EXPECT_NEAR(distance(state.nodes[0].position, {-1.5, -1.5}), 0, 1e-12);
  EXPECT_EQ(state.nodes[0].changed_by, ChangeKind::feature);
}

TEST(MoveInward, LeavesANodeThatIsFarEnough) {
  const FeatureState state = moved(plate(2), 0.5, {inner_node({-1.2, -1.2}, 3)}, {{1, 1}});
  EXPECT_EQ(state.nodes[0].position, (Vec2{-1.2, -1.2}));
}

TEST(MoveInward, StopsHalfwayToTheOppositeBoundary) {
  const CadFace face = hand_made::face({rectangle({0, 0}, {4, 1}, 0)}, std::sqrt(17.0));
  const FeatureState state = moved(face, 0.8, {inner_node({0.1, 0.1}, 3)}, {{1, 1}});
  EXPECT_NEAR(distance(state.nodes[0].position, {0.5, 0.5}), 0, 1e-9);
}

TEST(MoveInward, StopsWhereANodeThatStaysIsAsNearAsTheBoundary) {
  const FeatureState state = moved(plate(2), 0.9, {inner_node({-1.9, 0}, 3), inner_node({-1, 0}, 3)}, {{1, 0}});
  EXPECT_NEAR(distance(state.nodes[0].position, {-1.5, 0}), 0, 1e-9);
  EXPECT_EQ(state.nodes[1].position, (Vec2{-1, 0}));
}

TEST(MoveInward, IsNotStoppedByNodesOnTheBoundary) {
  // They are never nearer than the boundary itself: between the side at -2 and the hole at -1.2 it stops midway.
  const CadFace face = plate(2, {window({-1.2, -0.2}, {1, 0.2}, 0)});
  const FeatureState state = moved(face, 0.9, {inner_node({-1.9, 0}, 3), boundary_node(face, 4, 0.2)}, {{1, 0}});
  EXPECT_NEAR(distance(state.nodes[0].position, {-1.6, 0}), 0, 1e-9);
}

TEST(MoveInward, DecidesTwoThatMeetTogether) {
  const CadFace face = hand_made::face({rectangle({0, 0}, {4, 1.2}, 0)}, std::hypot(4, 1.2));
  const FeatureState state =
      moved(face, 0.7, {inner_node({3.9, 0.1}, 3), inner_node({3.9, 1.1}, 3)}, {{-1, 1}, {-1, -1}});
  EXPECT_NEAR(distance(state.nodes[0].position, {3.6, 0.4}), 0, 1e-9);  // 1.2 - 2 w = w
  EXPECT_NEAR(distance(state.nodes[1].position, {3.6, 0.8}), 0, 1e-9);
}

TEST(InwardMove, FollowsTheBisectorOfABendForOneNode) {
  const CadFace face = hand_made::face({rectangle({0, 0}, {4, 4}, 0.1)}, std::sqrt(32.0));
  const SmallFeature bend = small_features(face, 0.3).at(0);
  const FeatureNode node = inner_node({0.1, 0.12}, 3);
  const InwardMove move = inward_move(face, node, bend, {0, bend.section.foot(node.position)});
  EXPECT_NEAR(distance(move.direction, unit(pi / 4)), 0, 1e-12);
  EXPECT_NEAR(move.start.x, move.start.y, 1e-12);  // put onto the bisector first
  EXPECT_NEAR(move.start.x, 0.11, 1e-12);
}

TEST(InwardMove, LeadsAwayFromTheOwnFootWhereABendHasSeveral) {
  const CadFace face =
      hand_made::face({{curve::segment({-2, -0.1}, {2, -0.1}), curve::circular_arc({2, 0}, 0.1, -half_pi, half_pi),
                        curve::segment({2, 0.1}, {-2, 0.1}), curve::segment({-2, 0.1}, {-2, -0.1})}},
                      4.2);
  const SmallFeature end = small_features(face, 0.3).at(0);
  ASSERT_EQ(end.index_capacity, 2);
  const FeatureNode node = inner_node(Vec2{2, 0} + 0.05 * unit(0.5), 3);
  const InwardMove move = inward_move(face, node, end, {0, end.section.foot(node.position)});
  EXPECT_NEAR(distance(move.direction, -unit(0.5)), 0, 1e-9);
  EXPECT_EQ(move.start, node.position);
}

}  // namespace
}  // namespace quadrille::features
