#include "features/small_features.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace quadrille::features
