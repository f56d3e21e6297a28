#include "export/block_mesh_dict.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "export/hex_blocks.hpp"
#include "refine/refine.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

QuadMesh refined(const SeparatrixGraph& graph, double size, int order) {
  Report report;
  refine::RefineOptions options;
  options.size = size;
  options.order = order;
  return refine::refine(block::extract_blocks(graph, report), options, report);
}

TEST(BlockMeshDict, TwoQuadsWordByWord) {
  QuadMesh mesh = two_quads();
  mesh.face.metres_per_unit = 0.001;
  const Exported exported = block_mesh_dict(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes, R"(FoamFile
{
    version 2.0;
    format ascii;
    class dictionary;
    object blockMeshDict;
}

scale 0.001;

vertices
(
    (0 0 0)
    (2 0 0)
    (2 2 0)
    (0 2 0)
    (4 0 0)
    (4 2 0)
    (0 0 0.5)
    (2 0 0.5)
    (2 2 0.5)
    (0 2 0.5)
    (4 0 0.5)
    (4 2 0.5)
);

edges
(
);

blocks
(
    hex (0 1 2 3 6 7 8 9) left (1 1 1) simpleGrading (1 1 1)
    hex (1 4 5 2 7 10 11 8) right (1 1 1) simpleGrading (1 1 1)
);

boundary
(
    wall
    {
        type patch;
        faces
        (
            (0 1 7 6)
            (2 3 9 8)
            (1 4 10 7)
            (5 2 8 11)
        );
    }
    in___out
    {
        type patch;
        faces
        (
            (4 5 11 10)
        );
    }
    curve_3
    {
        type patch;
        faces
        (
            (3 0 6 9)
        );
    }
    frontAndBack
    {
        type empty;
        faces
        (
            (0 3 2 1)
            (6 7 8 9)
            (1 2 5 4)
            (7 10 11 8)
        );
    }
);

mergePatchPairs
(
);
)");
  ASSERT_EQ(exported.losses.size(), 2u);
  EXPECT_EQ(exported.losses[0],
            "cells have straight sides, which moves the boundary by up to 0.5 (0.1 of the diameter)");
}

TEST(BlockMeshDict, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const std::string text = block_mesh_dict(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(page("openfoam.md").find("```\n" + text + "```\n"), std::string::npos);
}

TEST(BlockMeshDict, OneBlockWithSplines) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), 0.3, 4);
  const std::string text = block_mesh_dict(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("hex (0 1 2 3 4 5 6 7)"), std::string::npos);
  EXPECT_EQ(text.find("hex", text.find("hex") + 1), std::string::npos);
  std::size_t num_splines = 0;
  for (std::size_t at = text.find("spline"); at != std::string::npos; at = text.find("spline", at + 1)) ++num_splines;
  EXPECT_EQ(num_splines, 4u);  // two arcs in two planes
}

TEST(HexBlocks, NamesThatEndWithinASideCutBlocks) {
  const QuadMesh mesh = refined(hand_made::elbow(), 0.3, 3);
  const HexBlocks hexes = hex_blocks(mesh, mesh_groups(mesh));
  EXPECT_EQ(hexes.blocks.size(), 2u);
  ASSERT_EQ(hexes.patches.size(), 6u);
  for (const auto& patch : hexes.patches) EXPECT_EQ(patch.size(), 1u);
}

TEST(HexBlocks, RingsAreCutUntilSidesHaveEndsOfTheirOwn) {
  for (const int cuts : {1, 2}) {
    const QuadMesh mesh = refined(hand_made::cut_annulus(cuts), 0.2, 3);
    const HexBlocks hexes = hex_blocks(mesh, mesh_groups(mesh));
    EXPECT_GE(hexes.blocks.size(), 3u);
    std::size_t on_boundary = 0;
    for (const auto& patch : hexes.patches) on_boundary += patch.size();
    EXPECT_GE(on_boundary, 6u);
    int cells = 0;
    for (const HexBlock& block : hexes.blocks) cells += block.edges[0].num_cells() * block.edges[1].num_cells();
    EXPECT_EQ(cells, mesh.num_elems());
  }
}

TEST(HexBlocks, RefusesSidesOfQuadsWithTheSameEnds) {
  const QuadMesh mesh = ring_of_two_quads();
  EXPECT_THROW(hex_blocks(mesh, mesh_groups(mesh)), ComputeError);
}

TEST(HexBlocks, RefusesCellsThatAreNotConvex) {
  QuadMesh mesh = two_straight_quads();
  mesh.nodes[4] = {3.5, 0.5};
  mesh.nodes[5] = {4, 3};
  EXPECT_NO_THROW(hex_blocks(two_straight_quads(), mesh_groups(two_straight_quads())));
  EXPECT_THROW(hex_blocks(mesh, mesh_groups(mesh)), ComputeError);
}

}  // namespace
}  // namespace quadrille::exports
