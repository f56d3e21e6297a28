#include "features/cancel_pairs.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

FeatureState cancelled(const CadFace& face, const std::vector<FeatureNode>& nodes, double below) {
  FeatureState state = state_of(face, 2 * below, nodes);
  cancel_pairs(face, state, BoundaryClearance(face), below);
  expect_sound_changes(state.changes);
  return state;
}

TEST(CancelPairs, RemovesTwoOfOppositeIndexThatAreNearerThanTheLength) {
  const std::vector<FeatureNode> pair{inner_node({0, 0}, 3), inner_node({0.1, 0}, 5)};
  EXPECT_TRUE(cancelled(plate(2), pair, 0.11).nodes.empty());
  EXPECT_EQ(cancelled(plate(2), pair, 0.1).nodes.size(), 2u);  // not nearer
}

TEST(CancelPairs, LeavesNodesOfOneSign) {
  const FeatureState state = cancelled(plate(2), {inner_node({0, 0}, 5), inner_node({0.1, 0}, 5)}, 0.5);
  EXPECT_EQ(state.nodes.size(), 2u);
  EXPECT_TRUE(state.changes.empty());
}

TEST(CancelPairs, TakesTheNearestPairFirst) {
  const FeatureState state =
      cancelled(plate(2), {inner_node({0, 0}, 3), inner_node({0.1, 0}, 5), inner_node({0.25, 0}, 3)}, 0.5);
  ASSERT_EQ(state.nodes.size(), 1u);
  EXPECT_EQ(state.nodes[0].position, (Vec2{0.25, 0}));
  EXPECT_FALSE(state.nodes[0].is_changed());
}

TEST(CancelPairs, PutsOneInTheMiddleOfPairsThatAreEquallyNear) {
  const FeatureState state =
      cancelled(plate(2), {inner_node({-0.1, 0}, 5), inner_node({0, 0}, 3), inner_node({0.1, 0}, 5)}, 0.2);
  ASSERT_EQ(state.nodes.size(), 1u);
  EXPECT_EQ(state.nodes[0].valence, 5);
  EXPECT_NEAR(norm(state.nodes[0].position), 0, 1e-15);
  EXPECT_EQ(state.nodes[0].changed_by, ChangeKind::cancel);
}

TEST(CancelPairs, LeavesSetsThatNoOneNodeCanReplaceAndGoesOnWithTheNextClass) {
  std::vector<FeatureNode> star{inner_node({0, 0}, 3)};
  for (int k = 0; k < 4; ++k) star.push_back(inner_node(0.3 * unit(k * half_pi), 5));
  EXPECT_EQ(cancelled(plate(2), star, 0.4).nodes.size(), 5u);
  star.push_back(inner_node({1, 1}, 3));
  star.push_back(inner_node({1, 1.35}, 5));  // farther apart than the star's pairs
  EXPECT_EQ(cancelled(plate(2), star, 0.4).nodes.size(), 5u);
}

TEST(CancelPairs, TakesABoundaryNodeWithAnInnerOneButNotTwoOfThem) {
  const CadFace face = plate(2);
  const FeatureNode on_boundary = boundary_node(face, 0, 2);  // (0, -2), index -1
  EXPECT_TRUE(cancelled(face, {on_boundary, inner_node({0, -1.9}, 3)}, 0.2).nodes.empty());
  const FeatureState both = cancelled(face, {on_boundary, boundary_node(face, 0, 2.1, 1)}, 0.2);
  EXPECT_EQ(both.nodes.size(), 2u);
}

TEST(CancelPairs, KeepsABoundaryNodeThatNothingBalances) {
  // Index -1, +1, -1 at equal distances: a middle would have to leave the boundary.
  const CadFace face = plate(2);
  const FeatureState state =
      cancelled(face, {boundary_node(face, 0, 1.9), inner_node({0, -1.95}, 3), boundary_node(face, 0, 2.1)}, 0.2);
  EXPECT_EQ(state.nodes.size(), 3u);
}

TEST(CancelPairs, LeavesNodesOfFilletsThatAreCornersAtTheirDistance) {
  const CadFace face = plate(2);
  const auto left = [&](double depth, double other_depth) {
    return cancelled(face, {inner_node({0, depth - 2}, 3), inner_node({2 - other_depth, -1}, 5)}, 3).nodes.size();
  };
  EXPECT_EQ(left(0.01, 0.01), 2u);
  EXPECT_EQ(left(0.2, 0.2), 0u);
  EXPECT_EQ(left(0.01, 0.2), 2u);
  EXPECT_EQ(left(0.2, 0.01), 2u);
  const CadFace window_face = plate(2, {window({-0.5, -0.5}, {0.5, 0.5}, 0.01)});
  const FeatureNode on_fillet = boundary_node(window_face, 4, window_face.curves[4].end() / 2);
  EXPECT_EQ(cancelled(window_face, {on_fillet, inner_node({-1, -1}, 3)}, 1).nodes.size(), 2u);
  EXPECT_EQ(cancelled(window_face, {on_fillet, inner_node({-0.55, -0.55}, 3)}, 1).nodes.size(), 0u);
}

TEST(CancelPairs, DoesNotReachThroughTheBoundary) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.1)});
  EXPECT_EQ(cancelled(face, {inner_node({0, 0.2}, 5), inner_node({0, -0.2}, 3)}, 0.45).nodes.size(), 2u);
}

}  // namespace
}  // namespace quadrille::features
