#include "block/measure_blocks.hpp"

#include <gtest/gtest.h>

#include "block_samples.hpp"

namespace quadrille::block {
namespace {

BlockMeasure only_block(const SeparatrixGraph& graph) {
  const std::vector<BlockMeasure> measures = measure_blocks(extract_blocks(graph));
  EXPECT_EQ(measures.size(), 1u);
  return measures.at(0);
}

TEST(MeasureBlocks, SquareIsPerfect) {
  const BlockMeasure m = only_block(hand_made::unit_square());
  EXPECT_NEAR(m.jacobian_bound, 0.25, 1e-12);
  EXPECT_NEAR(m.scaled_jacobian, 1, 1e-14);
  EXPECT_NEAR(m.boundary_distance, 0, 1e-15);
  EXPECT_EQ(m.divisions, 1);
  EXPECT_NEAR(m.area, 1, 1e-14);
  EXPECT_EQ(m.shortest_side, 1);
  EXPECT_EQ(m.shortest_side_index, 0);
}

TEST(MeasureBlocks, QuarterAnnulusIsOrthogonal) {
  const BlockMeasure m = only_block(hand_made::quarter_annulus());
  EXPECT_NEAR(m.scaled_jacobian, 1, 1e-7);
  EXPECT_NEAR(m.area, 0.75 * pi, 1e-10);
  EXPECT_NEAR(m.shortest_side, 1, 1e-14);
  EXPECT_GT(m.boundary_distance, 1e-12) << "no polynomial is an arc of a circle";
  EXPECT_LT(m.boundary_distance, 1e-8);
}

TEST(MeasureBlocks, ScaledJacobianIsFoundAtItsPlace) {
  const std::vector<Nurbs> loop{curve::segment({0, 0}, {2, 0}), curve::segment({2, 0}, {2, 1.5}),
                                curve::segment({2, 1.5}, {1, 1}), curve::segment({1, 1}, {0, 0})};
  const BlockMeasure m = only_block(hand_made::one_block(hand_made::face({loop}, 2.5), {{0}, {1}, {2}, {3}}));
  EXPECT_NEAR(m.scaled_jacobian, 1 / std::sqrt(10.0), 1e-12);
  EXPECT_NEAR(distance(m.scaled_jacobian_position, {1, 1}), 0, 1e-12);
  EXPECT_NEAR(m.area, 1.75, 1e-13);
}

TEST(MeasureBlocks, BoundaryDistanceIsTheGreatestErrorOfTheSides) {
  const BlockMeasure m = only_block(hand_made::elbow());
  // Half straight, half bent: a polynomial of order 8 misses the jump of the curvature by about a thousandth.
  EXPECT_GT(m.boundary_distance, 1e-4);
  EXPECT_LT(m.boundary_distance, 1e-2);
  EXPECT_GT(m.boundary_distance_position.x, -1e-3);
  EXPECT_LT(m.boundary_distance_position.x, 3.01);
}

TEST(MeasureBlocks, FoldedBlockCannotBeProved) {
  for (const SeparatrixGraph& graph : {block_samples::dart(), block_samples::near_tangent_strip()}) {
    const BlockMeasure m = only_block(graph);
    EXPECT_LE(m.jacobian_bound, 0);
    EXPECT_EQ(m.divisions, 0);
    EXPECT_EQ(m.scaled_jacobian, -1);
  }
}

}  // namespace
}  // namespace quadrille::block
