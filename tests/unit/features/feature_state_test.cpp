#include "features/feature_state.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

TEST(FeatureNode, HasTheIndexOfItsLocation) {
  EXPECT_EQ(inner_node({0, 0}, 5).index(), -1);
  const CadFace face = plate(1);
  EXPECT_EQ(boundary_node(face, 0, 1, 3).index(), -1);
  EXPECT_EQ(boundary_node(face, 0, 1, 4).index(), -2);
}

TEST(RemoveNodes, KeepsTheOthersInOrder) {
  FeatureState state = state_of(plate(1), 0.1, {inner_node({0, 0}, 3), inner_node({1, 0}, 5), inner_node({2, 0}, 3)});
  remove_nodes(state, {2, 0});
  ASSERT_EQ(state.nodes.size(), 1u);
  EXPECT_EQ(state.nodes[0].valence, 5);
  remove_nodes(state, {});
  EXPECT_EQ(state.nodes.size(), 1u);
}

TEST(Record, MarksNodesBeforeAndAfter) {
  const CadFace face = plate(1);
  FeatureState state = state_of(face, 0.1, {});
  record(state, ChangeKind::feature, {inner_node({0, 0}, 5)}, {boundary_node(face, 0, 1)}, "why");
  ASSERT_EQ(state.changes.size(), 1u);
  EXPECT_EQ(state.changes[0].before[0].location, NodeLocation::inside);
  EXPECT_EQ(state.changes[0].after[0].location, NodeLocation::boundary);
  EXPECT_EQ(state.changes[0].reason, "why");
}

}  // namespace
}  // namespace quadrille::features
