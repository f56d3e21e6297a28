#include "features/feature_owners.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

/// The nodes of each feature of the face.
std::vector<std::vector<int>> owned(const CadFace& face, double size, const std::vector<FeatureNode>& nodes) {
  const FeatureState state = state_of(face, size, nodes);
  std::vector<std::vector<int>> result;
  for (const auto& of_feature : nodes_of_features(face, state, small_features(face, size))) {
    result.emplace_back();
    for (const OwnedNode& own : of_feature) result.back().push_back(own.node);
  }
  return result;
}

using Lists = std::vector<std::vector<int>>;

/// A square hole of side 2 with fillets of radius 0.1, the first at the lower left.
CadFace window_plate() { return plate(4, {window({-1, -1}, {1, 1}, 0.1)}); }

TEST(FeatureOwners, GiveAFeatureTheNodesOfItsSign) {
  const CadFace face = window_plate();
  EXPECT_EQ(owned(face, 0.3, {inner_node({-1.05, -1.05}, 5)}), (Lists{{0}, {}, {}, {}}));
  EXPECT_EQ(owned(face, 0.3, {inner_node({-1.05, -1.05}, 3)}), (Lists{{}, {}, {}, {}}));
  EXPECT_EQ(owned(face, 0.3, {inner_node({-1.05, -1.05}, 6)}), (Lists{{}, {}, {}, {}}));  // index -2
  const CadFace convex = hand_made::face({rectangle({0, 0}, {4, 4}, 0.1)}, std::sqrt(32.0));
  EXPECT_EQ(owned(convex, 0.3, {inner_node({0.1, 0.1}, 3)}), (Lists{{0}, {}, {}, {}}));
}

TEST(FeatureOwners, GiveNothingFartherThanTheSize) {
  const CadFace face = window_plate();
  const Vec2 arc = Vec2{-0.9, -0.9} + 0.1 * unit(radians(225));
  EXPECT_EQ(owned(face, 0.3, {inner_node(arc + 0.299 * unit(radians(225)), 5)})[0].size(), 1u);
  EXPECT_EQ(owned(face, 0.3, {inner_node(arc + 0.3 * unit(radians(225)), 5)})[0].size(), 0u);
}

TEST(FeatureOwners, GiveNoNodeHalfwayBetweenTwoFeatures) {
  const CadFace face = plate(4, {window({-1, -0.2}, {1, 0.2}, 0.1)});
  for (const auto& list : owned(face, 0.3, {inner_node({1.1, 0}, 5)})) EXPECT_TRUE(list.empty());
}

TEST(FeatureOwners, LeaveTheNodeThatALargerRunForced) {
  const CadFace face = plate(4, {window({-2, -2}, {0, 0}, 1), round_hole({0.6, 0.6}, 0.1)});
  EXPECT_EQ(owned(face, 0.9, {inner_node({0.1, 0.1}, 5)}), Lists(1));  // 0.56 from the arc, 0.61 from the hole
  EXPECT_EQ(owned(face, 0.9, {inner_node({0.2, 0.2}, 5)}), (Lists{{0}}));
}

TEST(FeatureOwners, GiveNoMoreThanTheCapacityNearestFirst) {
  const CadFace face = window_plate();
  const Vec2 out = unit(radians(225));
  EXPECT_EQ(owned(face, 0.3, {inner_node(Vec2{-1, -1} + 0.1 * out, 5), inner_node(Vec2{-1, -1} + 0.05 * out, 5)})[0],
            std::vector<int>{1});
  // Mirror images: both or none.
  EXPECT_TRUE(owned(face, 0.3, {inner_node({-1.1, -0.95}, 5), inner_node({-0.95, -1.1}, 5)})[0].empty());
}

TEST(FeatureOwners, GiveAHoleFour) {
  const CadFace face = plate(2, {round_hole({0, 0}, 0.1)});
  std::vector<FeatureNode> nodes;
  for (int k = 0; k < 5; ++k) nodes.push_back(inner_node((0.14 + 0.01 * k) * unit(pi / 4 + k * half_pi), 5));
  EXPECT_EQ(owned(face, 0.3, nodes), (Lists{{0, 1, 2, 3}}));
}

}  // namespace
}  // namespace quadrille::features
