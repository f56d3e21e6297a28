#include "export/merge_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "cell_masks.hpp"
#include "export/block_grid.hpp"

namespace quadrille::exports {
namespace {

using Mask = std::vector<std::string>;

/// The number of grids; all of them are rectangles.
int num_grids(const QuadMesh& mesh) {
  const QuadMesh merged = merge_blocks(mesh);
  EXPECT_TRUE(block_grids(merged).has_value());
  EXPECT_EQ(merged.elem_block.size(), mesh.elem_block.size());
  return static_cast<int>(merged.block_names.size());
}

/// The fewest rectangles, by trying all: the first square that is left is a corner of one.
int fewest_rectangles(Mask mask) {
  const int height = static_cast<int>(mask.size()), width = static_cast<int>(mask[0].size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (mask[y][x] == '.') continue;
      int best = 1000, right = width;
      for (int low = y; low < height && mask[low][x] == '#'; ++low) {
        for (int end = x; end < right; ++end)
          if (mask[low][end] == '.') right = end;
        for (int end = x + 1; end <= right; ++end) {
          Mask rest = mask;
          for (int row = y; row <= low; ++row) std::fill(rest[row].begin() + x, rest[row].begin() + end, '.');
          best = std::min(best, 1 + fewest_rectangles(rest));
        }
      }
      return best;
    }
  return 0;
}

TEST(MergeBlocks, ShapesWithKnownNumbers) {
  EXPECT_EQ(num_grids(mesh_of_mask({"####", "####", "####"})), 1);
  EXPECT_EQ(num_grids(mesh_of_mask({"#.", "##"})), 2);
  EXPECT_EQ(num_grids(mesh_of_mask({"###", "#.#", "###"})), 4);
  EXPECT_EQ(num_grids(mesh_of_mask({".#.", "###", ".#."})), 3);
}

TEST(MergeBlocks, FewestAsByTryingAllPartitions) {
  std::mt19937 random(7);  // the same numbers everywhere
  for (int sample = 0; sample < 300; ++sample) {
    Mask mask(4, "....");
    for (std::string& row : mask)
      for (char& mark : row)
        if (random() % 4 > 0) mark = '#';
    if (std::all_of(mask.begin(), mask.end(), [](const std::string& row) { return row == "...."; })) continue;
    EXPECT_EQ(num_grids(mesh_of_mask(mask)), fewest_rectangles(mask)) << mask[0] << '\n'
                                                                      << mask[1] << '\n'
                                                                      << mask[2] << '\n'
                                                                      << mask[3];
  }
}

TEST(MergeBlocks, RegionsStayApartAndKeepTheirNames) {
  const QuadMesh merged = merge_blocks(mesh_of_mask({"aab##", "aab##"}));
  EXPECT_EQ(merged.block_names, (std::vector<std::string>{"a", "b", "block_2"}));
  EXPECT_EQ(merged.unnamed_blocks, (std::vector<int>{2}));
  EXPECT_EQ(merged.elem_block, (std::vector<int>{0, 0, 1, 2, 2, 0, 0, 1, 2, 2}));
}

TEST(MergeBlocks, ARingIsCutInTheMiddleSoThatItDoesNotTouchItself) {
  const QuadMesh merged = merge_blocks(ring_of_cells(8, 2));
  EXPECT_EQ(merged.block_names.size(), 2u);
  EXPECT_EQ(std::count(merged.elem_block.begin(), merged.elem_block.end(), 0), 8);
}

TEST(MergeBlocks, AnInterfaceStaysALine) {
  QuadMesh mesh = mesh_of_mask({"####", "####"});
  mesh.face.curves.resize(2);
  mesh.interface_edges = {{1, 1, 1}, {2, 3, 1}};         // half of the line in the middle: an embedded curve
  EXPECT_EQ(merge_blocks(mesh).block_names.size(), 2u);  // the line goes on to the boundary
}

/// Three quads around a vertex.
TEST(MergeBlocks, AnIrregularVertexHasLines) {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.face.curves.resize(1);
  mesh.face.curve_names = {"side"};
  mesh.nodes.push_back({0, 0});
  for (int k = 0; k < 6; ++k) mesh.nodes.push_back((k % 2 == 0 ? 1.0 : 1.5) * unit(k * 1.0471975511965976));
  mesh.elem_nodes = {0, 1, 3, 2, 0, 3, 5, 4, 0, 5, 1, 6};
  mesh.elem_block = {0, 0, 0};
  mesh.block_names = {"block_0"};
  mesh.unnamed_blocks = {0};
  mesh.boundary_edges = {{0, 1, 0}, {0, 2, 0}, {1, 1, 0}, {1, 2, 0}, {2, 1, 0}, {2, 2, 0}};
  EXPECT_EQ(num_grids(mesh), 2);  // two of them make a rectangle
}

}  // namespace
}  // namespace quadrille::exports
