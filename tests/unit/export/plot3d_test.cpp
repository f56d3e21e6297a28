#include <gtest/gtest.h>

#include "cell_masks.hpp"
#include "export/merge_blocks.hpp"
#include "export/multi_block.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Plot3d, TwoGridsInFull) {
  const QuadMesh mesh = two_straight_quads();
  const Exported exported = plot3d(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes, R"(2
2 2 1
2 2 1
0 2 0 2
0 0 2 2
0 0 0 0
2 4 2 4
0 0 2 2
0 0 0 0
)");
  ASSERT_EQ(exported.side_files.size(), 2u);
  EXPECT_EQ(exported.side_files[0].name.ending, ".nmf");
  EXPECT_EQ(exported.side_files[0].bytes, R"(# Block IDIM JDIM KDIM
2
1 2 2 1
2 2 2 1
# Type B1 F1 S1 E1 S2 E2 B2 F2 S1 E1 S2 E2 Swap
wall 1 5 1 1 1 2
wall 1 6 1 1 1 2
curve_3 1 3 1 2 1 1
wall 2 5 1 1 1 2
in___out 2 4 1 2 1 1
wall 2 6 1 1 1 2
ONE_TO_ONE 1 4 1 2 1 1 2 3 1 2 1 1 FALSE
)");
}

TEST(Plot3d, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const Exported exported = plot3d(mesh, plane_frame(mesh.face));
  EXPECT_NE(page("plot3d.md").find("```\n" + exported.bytes + "```\n"), std::string::npos) << exported.bytes;
  EXPECT_NE(page("plot3d.md").find("```\n" + exported.side_files[0].bytes + "```\n"), std::string::npos)
      << exported.side_files[0].bytes;
}

/// Points of connected ranges are the same nodes, and every side of every grid is covered once.
void expect_complete(const MultiBlock& blocks) {
  std::vector<std::vector<int>> nodes;
  std::size_t covered = 0, sides = 0;
  for (const BlockGrid& grid : blocks.grids) {
    nodes.push_back(grid.vertices(blocks.quads));
    sides += 2 * (grid.num_i + grid.num_j);
  }
  const auto node_at = [&](const SideRange& range, int at) {
    const auto [i, j] = blocks.point(range, at);
    return nodes[range.grid][j * (blocks.grids[range.grid].num_i + 1) + i];
  };
  for (const BoundaryRange& b : blocks.boundaries) covered += b.range.end - b.range.begin;
  for (const GridConnection& c : blocks.connections) {
    const int count = c.first.end - c.first.begin;
    ASSERT_EQ(c.second.end - c.second.begin, count);
    covered += 2 * count;
    for (int k = 0; k <= count; ++k)
      EXPECT_EQ(node_at(c.first, c.first.begin + k), node_at(c.second, c.second.end - k));
  }
  EXPECT_EQ(covered, sides);
}

TEST(MultiBlock, RangesCoverAllSidesAndConnectEqualPoints) {
  for (const QuadMesh& mesh : {mesh_of_mask({"###", "#.#", "###"}), ring_of_cells(8, 3), two_quads()}) {
    const Groups groups = mesh_groups(mesh);
    expect_complete(multi_block(mesh, groups));
    expect_complete(multi_block(merge_blocks(mesh), groups));
  }
}

TEST(MultiBlock, ABlockThatIsNoGridIsDivided) {
  QuadMesh mesh = ring_of_cells(8, 2);
  std::fill(mesh.elem_block.begin(), mesh.elem_block.end(), 0);
  mesh.block_names = {"block_0"}, mesh.unnamed_blocks = {0};
  const MultiBlock blocks = multi_block(mesh, mesh_groups(mesh));
  EXPECT_EQ(blocks.grids.size(), 2u);
  expect_complete(blocks);
}

}  // namespace
}  // namespace quadrille::exports
