#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/writers.hpp"
#include "periodic_row.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Mfem, TwoQuadsInFull) {
  // Written by hand: vertices, then the middle of each edge as a loop over the quads meets them, then that of each
  // quad.
  const QuadMesh mesh = two_quads();
  const Exported exported = mfem_mesh13(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes, R"(MFEM mesh v1.3

dimension
2

elements
2
1 3 0 1 2 3
2 3 1 4 5 2

attribute_sets
2
"left" 1 1
"right" 1 2

boundary
6
1 1 0 1
1 1 1 4
2 1 4 5
1 1 5 2
1 1 2 3
3 1 3 0

bdr_attribute_sets
3
"wall" 1 1
"in & out" 1 2
"curve_3" 1 3

vertices
6

nodes
FiniteElementSpace
FiniteElementCollection: H1_2D_P2
VDim: 2
Ordering: 1

0 0
2 0
2 2
0 2
4 0
4 2
1 0
2 1
1 2
0 1
3 0
4 1
3 2.5
1 1
3 1.25

mfem_mesh_end
)");
  EXPECT_TRUE(exported.losses.empty());
  EXPECT_TRUE(exported.side_files.empty());
}

TEST(Mfem, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const Frame frame = plane_frame(mesh.face);
  const std::string shown = page("mfem.md");
  EXPECT_NE(shown.find("```\n" + mfem_mesh13(mesh, frame).bytes + "```\n"), std::string::npos);
  EXPECT_NE(shown.find("```json\n" + mfem_mesh10(mesh, frame).side_files.at(0).bytes + "```\n"), std::string::npos);
}

TEST(Mfem, OrderOneIsItsVertices) {
  const QuadMesh mesh = two_straight_quads();
  EXPECT_EQ(mfem_mesh10(mesh, plane_frame(mesh.face)).bytes, R"(MFEM mesh v1.0

dimension
2

elements
2
1 3 0 1 2 3
2 3 1 4 5 2

boundary
6
1 1 0 1
1 1 1 4
2 1 4 5
1 1 5 2
1 1 2 3
3 1 3 0

vertices
6
2
0 0
2 0
2 2
0 2
4 0
4 2
)");
}

TEST(Mfem, NamesThatVersion10CannotHoldAreInATable) {
  const QuadMesh mesh = two_quads();
  const Exported exported = mfem_mesh10(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes.substr(0, 15), "MFEM mesh v1.0\n");
  EXPECT_EQ(exported.bytes.find("sets"), std::string::npos);
  ASSERT_EQ(exported.side_files.size(), 1u);
  EXPECT_EQ(exported.side_files[0].name.ending, ".names.json");
  EXPECT_NE(exported.side_files[0].bytes.find(R"({"id": 2, "name": "in & out"})"), std::string::npos);
  EXPECT_NE(exported.side_files[0].bytes.find(R"({"id": 2, "name": "right"})"), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("3 boundaries and 2 regions"), std::string::npos);
}

TEST(Mfem, NamesAreQuotedAsMfemReadsThem) {
  QuadMesh mesh = two_quads();
  mesh.block_names = {R"(the "left" one)", R"(back\slash)"};
  const std::string text = mfem_mesh13(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("\n\"the \\\"left\\\" one\" 1 1\n\"back\\\\slash\" 1 2\n"), std::string::npos);
}

TEST(Mfem, RegionsOfOneNameAreOneAttribute) {
  QuadMesh mesh = two_quads();
  mesh.block_names = {"fluid", "fluid"};
  const std::string text = mfem_mesh13(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("\nelements\n2\n1 3 0 1 2 3\n1 3 1 4 5 2\n\nattribute_sets\n1\n\"fluid\" 1 1\n"),
            std::string::npos);
}

TEST(Mfem, ThirdCoordinateOnlyWhereThePlaneIsLeft) {
  const std::string curved = mfem_mesh10(two_quads(), upright_frame()).bytes;
  EXPECT_NE(curved.find("\nVDim: 3\n"), std::string::npos);
  EXPECT_NE(curved.find("\n7 3 2.5\n"), std::string::npos);
  const std::string straight = mfem_mesh10(two_straight_quads(), upright_frame()).bytes;
  EXPECT_NE(straight.find("\nvertices\n6\n3\n7 0 0\n7 2 0\n"), std::string::npos);
}

TEST(Mfem, VerticesOfPeriodicSidesAreOneAndNodesDiscontinuous) {
  const QuadMesh mesh = periodic_row(3);
  const Exported exported = mfem_mesh13(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes, R"(MFEM mesh v1.3

dimension
2

elements
3
1 3 0 1 2 3
1 3 1 4 5 2
1 3 4 0 3 5

attribute_sets
1
"gas" 1 1

boundary
8
1 1 0 1
1 1 1 4
1 1 4 0
2 1 0 3
3 1 3 5
3 1 5 2
3 1 2 3
4 1 3 0

bdr_attribute_sets
4
"low" 1 1
"right" 1 2
"high" 1 3
"left" 1 4

vertices
6

nodes
FiniteElementSpace
FiniteElementCollection: L2_T1_2D_P1
VDim: 2
Ordering: 1

0 0
1 0
0 1
1 1
1 0
2 0
1 1
2 1
2 0
3 0
2 1
3 1

mfem_mesh_end
)");
  EXPECT_TRUE(exported.losses.empty());
}

TEST(Mfem, PeriodicSidesWithTooFewElementsBetweenThemAreReported) {
  const QuadMesh mesh = periodic_row(2);
  const Exported exported = mfem_mesh13(mesh, plane_frame(mesh.face));
  EXPECT_NE(exported.bytes.find("\nvertices\n6\n2\n0 0\n"), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("refine to at least three elements"), std::string::npos);
}

TEST(Mfem, EdgesThatItCannotTellApartAreRefused) {
  const QuadMesh mesh = ring_of_two_quads();
  try {
    mfem_mesh13(mesh, plane_frame(mesh.face));
    FAIL() << "written";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("(1, 0) and (-1, 0)"), std::string::npos);
  }
}

}  // namespace
}  // namespace quadrille::exports
