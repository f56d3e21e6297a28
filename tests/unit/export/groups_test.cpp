#include "export/groups.hpp"

#include <gtest/gtest.h>

#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Groups, CurvesOfOneNameAreOneBoundaryAndThoseWithoutANameGetOne) {
  const Groups groups = mesh_groups(two_quads());
  EXPECT_EQ(groups.boundary_names, (std::vector<std::string>{"wall", "in & out", "curve_3"}));
  EXPECT_EQ(groups.curve2boundary, (std::vector<int>{0, 1, 0, 2}));
}

TEST(Groups, BlocksOfOneNameAreOneRegion) {
  EXPECT_EQ(mesh_groups(two_quads()).block2region, (std::vector<int>{0, 1}));
  const Groups groups = mesh_groups(two_quads_of_the_pages());
  EXPECT_EQ(groups.region_names, std::vector<std::string>{"fluid"});
  EXPECT_EQ(groups.block2region, (std::vector<int>{0, 0}));
}

TEST(Groups, BlocksWithoutANameAreOneRegion) {
  QuadMesh mesh = two_quads();
  mesh.unnamed_blocks = {0, 1};
  EXPECT_EQ(mesh_groups(mesh).region_names, std::vector<std::string>{"domain"});
  EXPECT_EQ(mesh_groups(mesh).is_region_named, std::vector<bool>{false});
  mesh.unnamed_blocks = {0};
  mesh.block_names[1] = "domain";
  EXPECT_EQ(mesh_groups(mesh).region_names, (std::vector<std::string>{"domain_", "domain"}));
  EXPECT_EQ(mesh_groups(mesh).is_region_named, (std::vector<bool>{false, true}));
}

TEST(Groups, SeparatedBlocksKeepNamesOfTheirOwn) {
  QuadMesh mesh = two_quads();
  mesh.face.name = "left";
  separate_blocks(mesh);
  EXPECT_EQ(mesh_groups(mesh).region_names, (std::vector<std::string>{"block_0", "right"}));
  mesh = two_quads();
  mesh.unnamed_blocks = {0, 1};
  separate_blocks(mesh);
  EXPECT_EQ(mesh_groups(mesh).region_names, (std::vector<std::string>{"block_0", "block_1"}));
  EXPECT_EQ(mesh_groups(mesh).is_region_named, (std::vector<bool>{true, true}));
}

}  // namespace
}  // namespace quadrille::exports
