#include "export/block_mesh_text.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

/// Two plates between z = 0 and z = 1.
struct BlockMeshText : testing::Test {
  QuadMesh quads = two_straight_quads();
  PlateBlocks plates = plate_blocks(quads, mesh_groups(quads));
  BlockMesh mesh{plates, quads.nodes, [](Vec2 x, bool is_above) {
                   return std::array<double, 3>{x.x, x.y, is_above ? 1.0 : 0.0};
                 }};

  BlockMeshText() { mesh.zones = {"left", "right"}; }
};

TEST_F(BlockMeshText, VerticesOfTheUpperSideAreCountedAfterThoseOfTheLowerOne) {
  EXPECT_EQ(mesh.above(), 6);
  const std::string text = block_mesh_text(mesh);
  const std::size_t begin = text.find("vertices\n(\n"), end = text.find(");", begin);
  EXPECT_EQ(count(text.substr(begin, end - begin), " 0)\n"), 6);
  EXPECT_EQ(count(text.substr(begin, end - begin), " 1)\n"), 6);
  expect_counts(text, {{"    hex (", 2}, {" left (1 1 1) simpleGrading (1 1 1)\n", 1}, {"    spline", 0}});
  expect_contains(text, "scale 1;\n");
}

/// Upright and end faces have the outside on the reader's side.
TEST_F(BlockMeshText, FacesAreSeenFromOutside) {
  const auto at = [&](int vertex) {
    const auto [x, y, z] = mesh.at(quads.nodes[plates.vertices[vertex % 6]], vertex >= 6);
    return Vec3{x, y, z};
  };
  const auto check = [&](const std::array<int, 4>& face) {
    const Vec3 normal = cross(at(face[1]) - at(face[0]), at(face[3]) - at(face[0]));
    EXPECT_GT(dot(normal, at(face[0]) - Vec3{2, 1, 0.5}), 0);
  };
  int count = 0;
  for (int boundary = 0; boundary < static_cast<int>(plates.patches.size()); ++boundary)
    for (const auto& face : mesh.side_faces(boundary)) check(face), ++count;
  for (const bool is_above : {false, true})
    for (const auto& face : mesh.end_faces(is_above)) check(face), ++count;
  EXPECT_EQ(count, 6 + 4);
}

TEST_F(BlockMeshText, UnevenEdgesAndLayersAreSections) {
  mesh.layers = {0.25, 0.75};
  EXPECT_EQ(count(block_mesh_text(mesh), "        ((0.25 1 1)(0.75 1 1))\n"), 2 * 4);
  mesh.layers = {0.5, 0.5};
  EXPECT_EQ(count(block_mesh_text(mesh), "(1 1 2) simpleGrading (1 1 1)\n"), 2);
  plates.blocks[0].edges[2].fractions = {0.4, 0.6};
  const std::string text = block_mesh_text(mesh);
  expect_counts(text, {{"edgeGrading", 1}, {"((0.4 1 1)(0.6 1 1))", 2}, {"        1 1 1 1\n", 1}});
}

TEST_F(BlockMeshText, PatchesWithoutFacesAreLeftOut) {
  mesh.patches = {{"none", "wall"}, {"some", "cyclic", "        neighbourPatch other;\n", {{0, 1, 7, 6}}}};
  const std::string text = block_mesh_text(mesh);
  EXPECT_EQ(count(text, "none"), 0);
  expect_contains(text,
                  "    some\n    {\n        type cyclic;\n        neighbourPatch other;\n        faces\n        (\n "
                  "           (0 1 7 6)\n        );\n    }\n");
}

TEST_F(BlockMeshText, CurvedSidesAndInnerPointsAreLosses) {
  EXPECT_TRUE(block_mesh_losses(quads, plates).empty());
  plates.moved = 0.01;
  const std::vector<std::string> moved = block_mesh_losses(quads, plates);
  ASSERT_EQ(moved.size(), 1u);
  expect_contains(moved[0], "blockMesh places the points inside blocks itself, which moves them by up to 0.01");
  plates.moved = 1e-13;
  EXPECT_TRUE(block_mesh_losses(quads, plates).empty()) << "rounding";
}

}  // namespace
}  // namespace quadrille::exports
