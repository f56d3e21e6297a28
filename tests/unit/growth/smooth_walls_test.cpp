#include "growth/smooth_walls.hpp"

#include <gtest/gtest.h>

namespace quadrille::growth {
namespace {

// Three blocks of two elements each. `least`: scaled Jacobians of the elements.
QuadMesh mesh_of(const std::vector<double>& least) {
  QuadMesh mesh;
  mesh.block_names = {"a", "b", "c"};
  mesh.elem_block = {0, 0, 1, 1, 2, 2};
  mesh.elem_scaled_jacobian = least;
  mesh.elem_jacobian_bound.assign(6, 0.1);
  return mesh;
}

BlockLines lines_of(int num_blocks) { return BlockLines(num_blocks, layers::BlockLineLengths{{{{1.0}}, {{1.0}}}}); }

TEST(BlockQualities, AreThoseOfTheWorstElementAndZeroIfOneIsNotProved) {
  QuadMesh mesh = mesh_of({0.9, 0.8, 0.7, 0.6, 0.5, 0.4});
  mesh.elem_jacobian_bound[5] = 0;
  EXPECT_EQ(block_qualities(mesh), (std::vector<double>{0.8, 0.6, 0}));
}

TEST(DropWorse, BlocksThatLoseQualityLoseTheirLines) {
  BlockLines lines = lines_of(3);
  // a: less than before, but good; b: bad, but nearly as before; c: bad, and worse than before.
  EXPECT_TRUE(drop_worse({0.9, 0.2, 0.4}, mesh_of({0.9, 0.51, 0.19, 0.7, 0.3, 0.9}), lines));
  EXPECT_FALSE(lines[0][0].empty());
  EXPECT_FALSE(lines[1][0].empty());
  EXPECT_TRUE(lines[2][0].empty());
  EXPECT_FALSE(drop_worse({0.9, 0.2, 0.4}, mesh_of({0.9, 0.51, 0.19, 0.7, 0.3, 0.9}), lines)) << "nothing is left";
}

TEST(DropWorse, BlocksThatAreNotProvedLoseTheirLinesHoweverBadTheyWere) {
  BlockLines lines = lines_of(3);
  QuadMesh mesh = mesh_of({0.9, 0.9, 0.9, 0.9, 0.9, 0.9});
  mesh.elem_jacobian_bound[2] = -1;
  EXPECT_TRUE(drop_worse({0.9, 0, 0.9}, mesh, lines));
  EXPECT_FALSE(lines[0][0].empty());
  EXPECT_TRUE(lines[1][0].empty());
}

}  // namespace
}  // namespace quadrille::growth
