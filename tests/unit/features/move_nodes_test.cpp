#include "features/move_nodes.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

struct Put {
  FeatureState state;
  std::vector<int> taken;
};

/// All nodes belong to the face's small feature number `id`.
Put put(const CadFace& face, double size, int id, const std::vector<FeatureNode>& nodes) {
  Put result{state_of(face, size, nodes), {}};
  result.state.corners = corners_of(face);
  const SmallFeature feature = small_features(face, size).at(id);
  std::vector<OwnedNode> owned;
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
    owned.push_back({i, feature.section.foot(nodes[i].position)});
  result.taken = put_on_boundary(face, result.state, feature, id, owned);
  expect_sound_changes(result.state.changes);
  return result;
}

TEST(PutOnBoundary, PutsTheNodeOfAFilletIntoTheMiddleOfItsArc) {
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0.1)});
  const Put done = put(face, 0.3, 0, {inner_node({-1.1, -0.96}, 5)});
  const FeatureNode& node = done.state.nodes[0];
  EXPECT_EQ(node.location, NodeLocation::boundary);
  EXPECT_EQ(node.valence, 3);
  EXPECT_NEAR(distance(node.position, Vec2{-0.9, -0.9} + 0.1 * unit(radians(225))), 0, 1e-12);
  EXPECT_NEAR(distance(node.position, curve::point(face.curves[node.curve], node.t)), 0, 1e-14);
  EXPECT_EQ(node.changed_by, ChangeKind::feature);
  EXPECT_FALSE(node.hole.has_value());
  EXPECT_TRUE(done.taken.empty());
}

TEST(PutOnBoundary, PutsTheNodesOfAHoleToTheirFeet) {
  std::vector<FeatureNode> nodes;
  for (int k = 0; k < 4; ++k) nodes.push_back(inner_node(0.14 * unit(0.3 + 1.1 * k), 5));
  const Put done = put(plate(2, {round_hole({0, 0}, 0.1)}), 0.205, 0, nodes);
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(distance(done.state.nodes[k].position, 0.1 * unit(0.3 + 1.1 * k)), 0, 1e-12);
    EXPECT_EQ(done.state.nodes[k].hole, 0);
  }
}

TEST(PutOnBoundary, SpreadsCrowdedNodesOfAHoleEvenly) {
  const Put done = put(plate(2, {round_hole({0, 0}, 0.1)}), 0.25, 0,
                       {inner_node({0.13, 0.001}, 5), inner_node({0.14, -0.001}, 5), inner_node({-0.13, 0.01}, 5),
                        inner_node({-0.13, -0.01}, 5)});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) EXPECT_GE(distance(done.state.nodes[i].position, done.state.nodes[j].position), 0.14);
}

TEST(PutOnBoundary, LetsACornerTakeTheNodeBeforeIt) {
  const double s = 0.1;
  const CadFace face = plate(2, {filleted({{-s, 0}, {0, s * std::sqrt(3.0)}, {s, 0}}, {0, 0, 0})});
  const Put done = put(face, 0.5, 0, {inner_node({0, 0.25}, 5)});
  EXPECT_EQ(done.taken, std::vector<int>{0});
  std::vector<int> grown;
  for (const Corner& corner : done.state.corners)
    if (corner.source == NodeSource::feature) grown.push_back(corner.valence);
  EXPECT_EQ(grown, std::vector<int>{4});
}

TEST(PutOnBoundary, LeavesTheNodeWhereTheCornerHasNoRoomForABlockMore) {
  const double s = 0.1;
  const CadFace face = plate(2, {filleted({{-s, 0}, {0, s * std::sqrt(3.0)}, {s, 0}}, {0, 0, 0})});
  FeatureState state = state_of(face, 0.5, {inner_node({0, 0.25}, 5)});
  state.corners = corners_of(face);
  for (Corner& corner : state.corners) corner.valence = 4;
  const SmallFeature feature = small_features(face, 0.5).at(0);
  EXPECT_TRUE(put_on_boundary(face, state, feature, 0, {{0, feature.section.foot({0, 0.25})}}).empty());
  EXPECT_EQ(state.nodes[0].location, NodeLocation::inside);
  EXPECT_TRUE(state.changes.empty());
}

using namespace testing_features;

/// Moves the first nodes, one from each start along each direction; the others stay.
FeatureState moved(const CadFace& face, double size, const std::vector<FeatureNode>& nodes,
                   const std::vector<Vec2>& directions) {
  FeatureState state = state_of(face, size, nodes);
  std::vector<InwardMove> moves;
  for (size_t i = 0; i < directions.size(); ++i)
    moves.push_back({static_cast<int>(i), nodes[i].position, normalized(directions[i]), 0.1});
  move_inward(state, curve::FaceBoundary(face), moves);
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
