#include "growth/smooth_walls.hpp"

#include <gtest/gtest.h>

#include <array>

#include "mesh/mesh_score.hpp"

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

/// That of blocks with these least scaled Jacobians.
std::vector<double> skewness_of(const std::vector<double>& least) {
  std::vector<double> twice;
  for (const double quality : least) twice.insert(twice.end(), 2, quality);
  return mesh::block_skewness(mesh_of(twice));
}

/// The walls beside three blocks: their numbers by side.
layers::WallSides walls_of(const std::array<std::array<int, 4>, 3>& of_block) {
  layers::WallSides walls;
  walls.of_block.assign(of_block.begin(), of_block.end());
  return walls;
}

constexpr std::array<int, 4> no_wall{-1, -1, -1, -1};

TEST(DropWorse, BlocksThatLoseQualityLoseTheirLines) {
  BlockLines lines = lines_of(3);
  const layers::WallSides walls = walls_of({no_wall, no_wall, no_wall});
  // a: less than before, but good; b: bad, but nearly as before; c: bad, and worse than before.
  const QuadMesh mesh = mesh_of({0.9, 0.71, 0.192, 0.7, 0.3, 0.9});
  EXPECT_TRUE(drop_worse(skewness_of({0.9, 0.2, 0.4}), mesh, walls, lines));
  EXPECT_FALSE(lines[0][0].empty());
  EXPECT_FALSE(lines[1][0].empty());
  EXPECT_TRUE(lines[2][0].empty() && lines[2][1].empty());
  EXPECT_FALSE(drop_worse(skewness_of({0.9, 0.2, 0.4}), mesh, walls, lines)) << "nothing is left";
}

TEST(DropWorse, BlocksThatAreNotProvedLoseTheirLinesHoweverBadTheyWere) {
  BlockLines lines = lines_of(3);
  QuadMesh mesh = mesh_of({0.9, 0.9, 0.9, 0.9, 0.9, 0.9});
  mesh.elem_jacobian_bound[2] = -1;
  EXPECT_TRUE(drop_worse(skewness_of({0.9, 0, 0.9}), mesh, walls_of({no_wall, no_wall, no_wall}), lines));
  EXPECT_FALSE(lines[0][0].empty());
  EXPECT_TRUE(lines[1][0].empty());
}

TEST(DropWorse, NormalsOfWallsAreDroppedLast) {
  BlockLines lines = lines_of(3);
  // Walls below a, to the right of b, none at c.
  const layers::WallSides walls = walls_of({{{0, -1, -1, -1}, {-1, 1, -1, -1}, no_wall}});
  const QuadMesh bad = mesh_of({0.1, 0.1, 0.1, 0.1, 0.1, 0.1});
  EXPECT_TRUE(drop_worse(skewness_of({0.9, 0.9, 0.9}), bad, walls, lines));
  for (const int block : {0, 1}) {
    EXPECT_FALSE(lines[block][block].empty()) << block;
    EXPECT_TRUE(lines[block][1 - block].empty()) << block;
  }
  EXPECT_TRUE(lines[2][0].empty() && lines[2][1].empty());
  EXPECT_TRUE(drop_worse(skewness_of({0.9, 0.9, 0.9}), bad, walls, lines));
  for (const int block : {0, 1}) EXPECT_TRUE(lines[block][0].empty() && lines[block][1].empty()) << block;
}

}  // namespace
}  // namespace quadrille::growth
