#include "features/put_on_boundary.hpp"

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

}  // namespace
}  // namespace quadrille::features
