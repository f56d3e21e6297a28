#include "simplify/block_quality.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::simplify {
namespace {

BlockQuality quality_of(const graph::Subdivision& subdivision, BlockQuads& quads) {
  return worst_quality(subdivision, all_faces(subdivision), quads);
}

TEST(BlockQuality, OfASquareAndOfASkewBlock) {
  const SeparatrixGraph square = hand_made::unit_square();
  BlockQuads quads;
  const BlockQuality quality = quality_of(graph::Subdivision(square), quads);
  EXPECT_NEAR(quality.least_angle, half_pi, 1e-12);
  EXPECT_NEAR(quality.greatest_angle, half_pi, 1e-12);
  EXPECT_NEAR(quality.least_scaled_jacobian, 1, 1e-12);
  EXPECT_EQ(quads.size(), 1u);
  EXPECT_TRUE(are_valid(quads));
  const SeparatrixGraph skew =
      hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {2, 1}),
                                             curve::segment({2, 1}, {1, 1}), curve::segment({1, 1}, {0, 0})}},
                                           std::sqrt(5.0)),
                           {{0}, {1}, {2}, {3}});
  const BlockQuality slanted = quality_of(graph::Subdivision(skew), quads);
  EXPECT_NEAR(slanted.least_angle, pi / 4, 1e-12);
  EXPECT_NEAR(slanted.greatest_angle, 3 * pi / 4, 1e-12);
  EXPECT_NEAR(slanted.least_scaled_jacobian, std::sqrt(0.5), 1e-12);
}

TEST(BlockQuality, IsTheWorstOfAllBlocksWhetherMeasuredBeforeOrNot) {
  const graph::Subdivision subdivision(hand_made::l_shape());
  BlockQualities qualities;
  for (int round = 0; round < 2; ++round) {
    BlockQuality worst;
    for (const int f : all_faces(subdivision)) {
      BlockQuads quads;
      const BlockQuality expected = worst_quality(subdivision, {f}, quads), found = qualities.worst(subdivision, {f});
      EXPECT_EQ(found.least_angle, expected.least_angle);
      EXPECT_EQ(found.greatest_angle, expected.greatest_angle);
      EXPECT_EQ(found.least_scaled_jacobian, expected.least_scaled_jacobian);
      worst.add(expected);
    }
    EXPECT_EQ(qualities.worst(subdivision, all_faces(subdivision)).least_scaled_jacobian, worst.least_scaled_jacobian);
  }
}

TEST(BlockQuality, IsMeasuredAgainIfASideHasOtherPieces) {
  const auto block = [](Vec2 top) {
    return graph::Subdivision(
        hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, top),
                                               curve::segment(top, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                                             std::sqrt(2.0)),
                             {{0}, {1}, {2}, {3}}));
  };
  BlockQualities qualities;
  const double square = qualities.worst(block({1, 1}), {0}).least_scaled_jacobian;
  EXPECT_NEAR(square, 1, 1e-12);
  EXPECT_LT(qualities.worst(block({2, 3}), {0}).least_scaled_jacobian, 0.9);
}

TEST(BlockQuality, AFoldedBlockIsNotValid) {
  const SeparatrixGraph folded =
      hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {0.1, 0.1}),
                                             curve::segment({0.1, 0.1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                                           std::sqrt(2.0)),
                           {{0}, {1}, {2}, {3}});
  BlockQuads quads;
  quality_of(graph::Subdivision(folded), quads);
  EXPECT_FALSE(are_valid(quads));
}

TEST(BlockQuality, FacesBesideMarkedArcs) {
  const graph::Subdivision subdivision(hand_made::l_shape());
  EXPECT_TRUE(faces_beside(subdivision, {}).empty());
  EXPECT_EQ(faces_beside(subdivision, {8}).size(), 2u);  // one of the two lines inside: between two of three blocks
}

}  // namespace
}  // namespace quadrille::simplify
