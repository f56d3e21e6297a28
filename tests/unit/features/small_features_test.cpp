#include "features/small_features.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

/// A slot with half circles of radius 0.3 as ends.
Loop slot() {
  return {curve::circular_arc({1, 0}, 0.3, half_pi, -half_pi), curve::segment({1, -0.3}, {-1, -0.3}),
          curve::circular_arc({-1, 0}, 0.3, -half_pi, -3 * half_pi), curve::segment({-1, 0.3}, {1, 0.3})};
}

Loop ellipse(double height) {
  Loop loop = round_hole({0, 0}, 1);
  for (Vec2& pole : loop[0].poles) pole.y *= height;
  return loop;
}

TEST(IndexCapacity, RoundsUpFromFourTenthsOfARightAngle) {
  EXPECT_EQ(index_capacity_of(radians(35.9)), 0);
  EXPECT_EQ(index_capacity_of(radians(36.1)), 1);
  EXPECT_EQ(index_capacity_of(half_pi), 1);
  EXPECT_EQ(index_capacity_of(pi), 2);
}

TEST(SmallFeatures, AreFilletsBelowTheSizeOnly) {
  const CadFace face =
      hand_made::face({filleted({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {0.1, 0.2, 0, 1.0})}, std::sqrt(20.0));
  const std::vector<SmallFeature> small = small_features(face, 0.5);
  ASSERT_EQ(small.size(), 2u);
  EXPECT_EQ(small[0].kind, FeatureKind::convex);
  EXPECT_NEAR(small[0].extent, 0.1, 1e-12);
  EXPECT_EQ(small[0].index_capacity, 1);
  EXPECT_NEAR(small[1].section.length(), 0.1 * pi, 1e-12);
  EXPECT_EQ(small_features(face, 0.2).size(), 1u);  // 0.2 is not below 0.2
}

TEST(SmallFeatures, GiveHalfCirclesTwoAndHolesFour) {
  const CadFace face = plate(4, {slot(), round_hole({0, 2}, 0.3)});
  const std::vector<SmallFeature> ends = small_features(face, 0.4);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].kind, FeatureKind::reflex);
  EXPECT_EQ(ends[0].index_capacity, 2);
  const std::vector<SmallFeature> with_hole = small_features(face, 0.7);
  ASSERT_EQ(with_hole.size(), 3u);
  EXPECT_EQ(with_hole[2].kind, FeatureKind::hole);
  EXPECT_NEAR(with_hole[2].extent, 0.6, 1e-6);
  EXPECT_EQ(with_hole[2].index_capacity, 4);
}

TEST(SmallFeatures, TakeASmallEllipseForAHoleAndALargerOneForItsEnds) {
  const CadFace face = plate(9, {ellipse(0.3)});
  EXPECT_EQ(small_features(face, 1).size(), 2u);
  const std::vector<SmallFeature> whole = small_features(face, 2.1);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].kind, FeatureKind::hole);
}

TEST(SmallFeatures, ReadTheCapacityOfANoseOffItsFlanksToo) {
  // Radius 0.04 at the ends of the ellipse, which alone turn by less than a right angle.
  const std::vector<SmallFeature> ends = small_features(plate(4, {ellipse(0.2)}), 0.07);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_LT(ends[0].section.length(), 0.2);
  EXPECT_TRUE(ends[0].run.is_closed());
  EXPECT_EQ(ends[0].index_capacity, 4);
}

TEST(SmallFeatures, CountTheCornersOfAHole) {
  const Loop triangle = filleted({{-0.1, 0}, {0, 0.1 * std::sqrt(3.0)}, {0.1, 0}}, {0, 0, 0});
  const std::vector<SmallFeature> holes = small_features(plate(2, {triangle}), 0.5);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_EQ(holes[0].index_capacity, 1);  // three corners of 300 degrees have valence 3 each
}

TEST(RunsOfAnySize, AreAllThatForceNodesButTheOutlineItself) {
  const CadFace face = hand_made::face(
      {filleted({{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {3, 0, 0, 0}), round_hole({5, 5}, 1)}, std::sqrt(128.0));
  const std::vector<SmallFeature> runs = runs_of_any_size(face);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].kind, FeatureKind::convex);
  EXPECT_EQ(runs[1].kind, FeatureKind::hole);
  const CadFace disc = hand_made::face({{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}}, 2);
  EXPECT_TRUE(runs_of_any_size(disc).empty());
}

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

CadFace rectangle(double width, double height) {
  using curve::segment;
  return hand_made::face({{segment({0, 0}, {width, 0}), segment({width, 0}, {width, height}),
                           segment({width, height}, {0, height}), segment({0, height}, {0, 0})}},
                         std::hypot(width, height));
}

TEST(AutomaticSize, IsAPartOfTheDiameterButNotMoreThanHalfTheWidth) {
  EXPECT_NEAR(automatic_feature_size(rectangle(30, 40)), 0.1, 1e-14);
  // Area by half the perimeter: the width of a long strip.
  EXPECT_NEAR(automatic_feature_size(rectangle(1000, 1)), 1000.0 / 2002, 1e-12);
}

TEST(AutomaticSize, HolesMakeAFaceNarrow) {
  CadFace ring = hand_made::face(
      {{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}, {curve::circular_arc({0, 0}, 0.999, 2 * pi, 0)}}, 2);
  EXPECT_NEAR(automatic_feature_size(ring), 0.0005, 1e-10);
}

TEST(AutomaticSize, DoesNotDependOnHowFarAFarFieldReaches) {
  for (const double reach : {10.0, 100.0}) {
    CadFace face = hand_made::face(
        {{curve::circular_arc({0, 0}, reach, 0, 2 * pi)}, {curve::circular_arc({0, 0}, 1, 2 * pi, 0)}}, 2 * reach);
    face.curve_names = {"farfield", "body"};
    EXPECT_NEAR(automatic_feature_size(face), std::hypot(2, 2) / 500, 1e-12);
    face.curve_names[1] = "body_offset";
    EXPECT_NEAR(automatic_feature_size(face), 2 * reach / 500, 1e-12);
    face.curve_names = {"outline", "body"};
    EXPECT_NEAR(automatic_feature_size(face), 2 * reach / 500, 1e-12);
  }
}

TEST(AutomaticSize, TextsAreAutoOrALength) {
  const CadFace face = rectangle(30, 40);
  EXPECT_EQ(parse_feature_size("auto"), std::nullopt);
  EXPECT_EQ(parse_feature_size("0"), 0);
  EXPECT_EQ(parse_feature_size("2.5e-1"), 0.25);
  for (const char* text : {"-1", "1x", "", "nan", "inf", "automatic"})
    EXPECT_THROW(parse_feature_size(text), UsageError) << text;
}

}  // namespace
}  // namespace quadrille::features
