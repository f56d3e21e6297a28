#include <gtest/gtest.h>

#include "../samples.hpp"
#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

TEST(HexSheet, IsATabInSpaceAloneWithTheMeasuresOfElements) {
  HexMesh mesh = samples::hex_mesh();
  mesh.quad_block = {0, 1}, mesh.block_region = {1, 0}, mesh.region_names = {"fluid", "solid"};
  const Sheet sheet = stage_sheet(mesh, frame);
  EXPECT_TRUE(sheet.is_only_in_space);
  EXPECT_EQ(sheet.caption, "2 hexahedra of order 1 in 1 layer");
  ASSERT_EQ(sheet.layers.size(), 1u);
  const std::string layer = layer_of(sheet, "mesh");
  expect_contains(layer, member("regions", {1, 0}) + R"(,"regionNames":["fluid","solid"])");
  expect_counts(layer, {{R"("title":"scaled Jacobian")", 1}, {R"("title":"proved bound of det J")", 1}});
  EXPECT_FALSE(sheet.space.empty());
}

TEST(HexSheet, AMeshThatIsNotValidSaysSo) {
  HexMesh mesh = samples::hex_mesh();
  mesh.is_valid = false;
  EXPECT_EQ(stage_sheet(mesh, frame).caption, "NOT VALID: 2 hexahedra of order 1 in 1 layer");
}

}  // namespace
}  // namespace quadrille::page
