#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

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
        type wall;
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
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.3, 4});
  const std::string text = block_mesh_dict(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("hex (0 1 2 3 4 5 6 7)"), std::string::npos);
  EXPECT_EQ(text.find("hex", text.find("hex") + 1), std::string::npos);
  std::size_t num_splines = 0;
  for (std::size_t at = text.find("spline"); at != std::string::npos; at = text.find("spline", at + 1)) ++num_splines;
  EXPECT_EQ(num_splines, 4u);  // two arcs in two planes
}

}  // namespace
}  // namespace quadrille::exports
