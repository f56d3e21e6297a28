#include "simplify/block_quality.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::simplify {
namespace {

TEST(BlockQuality, OfASquareAndOfASkewBlock) {
  const SeparatrixGraph square = hand_made::unit_square();
  const BlockQuality quality = worst_quality(graph::Subdivision(square));
  EXPECT_NEAR(quality.least_angle, half_pi, 1e-12);
  EXPECT_NEAR(quality.greatest_angle, half_pi, 1e-12);
  EXPECT_NEAR(quality.least_scaled_jacobian, 1, 1e-12);
  EXPECT_TRUE(quality.is_valid);
  const SeparatrixGraph skew =
      hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {2, 1}),
                                             curve::segment({2, 1}, {1, 1}), curve::segment({1, 1}, {0, 0})}},
                                           std::sqrt(5.0)),
                           {{0}, {1}, {2}, {3}});
  const BlockQuality slanted = worst_quality(graph::Subdivision(skew));
  EXPECT_NEAR(slanted.least_angle, pi / 4, 1e-12);
  EXPECT_NEAR(slanted.greatest_angle, 3 * pi / 4, 1e-12);
  EXPECT_NEAR(slanted.least_scaled_jacobian, std::sqrt(0.5), 1e-12);
}

TEST(BlockQuality, AFoldedBlockIsNotValid) {
  const SeparatrixGraph folded =
      hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {0.1, 0.1}),
                                             curve::segment({0.1, 0.1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                                           std::sqrt(2.0)),
                           {{0}, {1}, {2}, {3}});
  EXPECT_FALSE(worst_quality(graph::Subdivision(folded)).is_valid);
}

TEST(BlockQuality, FacesBesideMarkedArcs) {
  const graph::Subdivision subdivision(hand_made::l_shape());
  EXPECT_TRUE(faces_beside(subdivision, {}).empty());
  EXPECT_EQ(faces_beside(subdivision, {8}).size(), 2u);  // one of the two lines inside: between two of three blocks
}

}  // namespace
}  // namespace quadrille::simplify
