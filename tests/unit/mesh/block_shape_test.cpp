#include "mesh/block_shape.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::mesh {
namespace {

/// Also checks the measures of the sampled block.
BlockShape shape_of(const std::vector<Vec2>& corners) {
  std::vector<Nurbs> loop;
  for (int k = 0; k < 4; ++k) loop.push_back(curve::segment(corners[k], corners[(k + 1) % 4]));
  const CadFace face = hand_made::face({loop}, 2);
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  std::vector<curve::Chain> chains;
  for (int k = 0; k < 4; ++k)
    chains.emplace_back(table, std::vector<ArcPiece>{{k, face.curves[k].begin(), face.curves[k].end()}});
  const TransfiniteMap map({&chains[0], &chains[1], &chains[2], &chains[3]}, {false, false, false, false});
  BlockShape shape = block_shape(map);
  EXPECT_EQ(scaled_jacobian(map.sampled(block_order)), shape.scaled_jacobian);
  EXPECT_EQ(is_valid_block(map.sampled(block_order)), shape.is_valid());
  return shape;
}

TEST(BlockShape, OfASquareOfSideTwo) {
  const BlockShape shape = shape_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_NEAR(shape.jacobian_bound, 1, 1e-9);
  EXPECT_NEAR(shape.scaled_jacobian, 1, 1e-12);
  EXPECT_TRUE(shape.is_valid());
}

TEST(BlockShape, ASlantedBlockHasTheSineOfItsAngle) {
  EXPECT_NEAR(shape_of({{0, 0}, {1, 0}, {2, 1}, {1, 1}}).scaled_jacobian, std::sqrt(0.5), 1e-12);
}

TEST(BlockShape, AFoldedBlockIsWorstWhereItFolds) {
  const BlockShape shape = shape_of({{0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}});
  EXPECT_FALSE(shape.is_valid());
  EXPECT_EQ(shape.scaled_jacobian, -1);
  EXPECT_LT(distance(shape.scaled_jacobian_position, {0.1, 0.1}), 0.3);
}

}  // namespace
}  // namespace quadrille::mesh
