#include "export/multi_block.hpp"

#include <gtest/gtest.h>

#include "export/cgns_request.hpp"
#include "export/merge_blocks.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(MultiBlock, Plot3dOfTwoGridsInFull) {
  const Exported exported = plot3d(two_hexes({.layers = 2}));
  EXPECT_TRUE(exported.bytes.starts_with(R"(2
2 2 3
2 2 3
0 2 0 2
0 2 0 2
0 2 0 2
0 0 2 2
0 0 2 2
0 0 2 2
0 0 0 0
1 1 1 1
2 2 2 2
2 4 2 4
)")) << exported.bytes;
  EXPECT_EQ(exported.side_files.at(0).bytes, R"(# Block IDIM JDIM KDIM
2
1 2 2 3
2 2 2 3
# Type B1 F1 S1 E1 S2 E2 B2 F2 S1 E1 S2 E2 Swap
wall 1 5 1 3 1 2
wall 1 6 1 3 1 2
wall 1 3 1 2 1 3
wall 2 5 1 3 1 2
outlet 2 4 1 2 1 3
wall 2 6 1 3 1 2
bottom 1 1 1 2 1 2
top 1 2 1 2 1 2
bottom 2 1 1 2 1 2
top 2 2 1 2 1 2
ONE_TO_ONE 1 4 1 2 1 3 2 3 1 2 1 3 FALSE
)");
}

TEST(MultiBlock, TheExampleOfThePage) {
  const std::string map = plot3d(two_hexes_of_the_pages()).side_files.at(0).bytes;
  EXPECT_NE(page("plot3d.md").find("```\n" + map + "```\n"), std::string::npos) << map;
}

/// The last level of a full turn is the first.
TEST(MultiBlock, AFullTurnIsItsOwnNeighbour) {
  HexMesh mesh = two_hexes({.layers = 3, .map = [](Vec3 x) {
                              const double turn = 2 * std::acos(-1.0) * x.z / 3;
                              return Vec3{(x.x + 3) * std::cos(turn), (x.x + 3) * std::sin(turn), -x.y};
                            }});
  for (HexFaceGroup& group : mesh.face_groups)
    if (group.name == "bottom" || group.name == "top") group.elems.clear(), group.faces.clear();
  const int last = static_cast<int>(mesh.nodes.size()) - 6;
  for (int& node : mesh.elem_nodes)
    if (node >= last) node -= last;
  mesh.nodes.resize(last);
  const CgnsRequest request = cgns_request(cgns_structured(mesh).bytes);
  ASSERT_EQ(request.zones[0].connections.size(), 3u);
  EXPECT_EQ(request.zones[0].connections[0].donor, "block_0");
  EXPECT_EQ(request.zones[0].connections[0].range, (std::vector<std::int64_t>{1, 1, 1, 2, 2, 1}));
  EXPECT_EQ(request.zones[0].connections[0].donor_range, (std::vector<std::int64_t>{1, 1, 4, 2, 2, 4}));
  EXPECT_NE(plot3d(mesh).side_files.at(0).bytes.find("ONE_TO_ONE 1 1 1 2 1 2 1 2 1 2 1 2 FALSE\n"), std::string::npos);
}

TEST(MultiBlock, BlocksOfOneRegionAreMerged) {
  HexMesh mesh = two_hexes({.order = 2, .layers = 2});
  EXPECT_EQ(merge_blocks(mesh).block_region.size(), 2u) << "an interface stays";
  mesh.block_region = {1, 1};
  mesh.face_groups[2].elems.clear(), mesh.face_groups[2].faces.clear();
  mesh = merge_blocks(std::move(mesh));
  EXPECT_EQ(mesh.quad_block, (std::vector<int>{0, 0}));
  EXPECT_EQ(mesh.block_region, std::vector<int>{1});
  const CgnsRequest request = cgns_request(cgns_structured(mesh).bytes);
  ASSERT_EQ(request.zones.size(), 1u);
  EXPECT_EQ(request.zones[0].size, (std::vector<std::int64_t>{5, 3, 5}));
}

}  // namespace
}  // namespace quadrille::exports
