#include "export/abaqus_inp.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "periodic_row.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(AbaqusInp, TwoQuadsWordByWord) {
  const QuadMesh mesh = two_quads();
  EXPECT_EQ(abaqus_inp(mesh, plane_frame(mesh.face)).bytes,
            "*Heading\n File created by HOHQMesh\n"
            "*NODE\n1, 0, 0, 0\n2, 2, 0, 0\n3, 2, 2, 0\n4, 0, 2, 0\n5, 4, 0, 0\n6, 4, 2, 0\n"
            "*ELEMENT, type=CPS4, ELSET=Surface1\n1, 1, 2, 3, 4\n2, 2, 5, 6, 3\n"
            "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = 2\n"
            "**  1 2 3 4\n**  0 0 0 0\n"
            "**  2 5 6 3\n**  0 0 1 0\n**  2 2 0\n**  3 2.5 0\n**  4 2 0\n"
            "** curve_3 --- wall wall\n** --- in___out wall wall\n");
}

TEST(AbaqusInp, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const std::string text = abaqus_inp(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(page("abaqus.md").find("```\n" + text + "```\n"), std::string::npos);
}

TEST(AbaqusInp, RefusesEdgesThatP4estCannotTellApart) {
  const QuadMesh mesh = ring_of_two_quads();
  EXPECT_THROW(abaqus_inp(mesh, plane_frame(mesh.face)), ComputeError);
}

TEST(AbaqusInp, PeriodicSidesHaveTheSameCornersAndTheirOwnInComments) {
  const QuadMesh mesh = periodic_row(3);
  const Exported exported = abaqus_inp(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes,
            "*Heading\n File created by HOHQMesh\n"
            "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 2, 0, 0\n6, 2, 1, 0\n7, 3, 0, 0\n8, 3, 1, 0\n"
            "*ELEMENT, type=CPS4, ELSET=Surface1\n1, 1, 2, 3, 4\n2, 2, 5, 6, 3\n3, 5, 1, 4, 6\n"
            "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = 1\n"
            "**  1 2 3 4\n**  0 0 0 0\n**  2 5 6 3\n**  0 0 0 0\n**  5 7 8 6\n**  0 0 0 0\n"
            "** --- --- low high\n** --- --- low high\n** --- --- low high\n");
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("other programs read wrong quads along \"left\" and \"right\""), std::string::npos);
}

TEST(AbaqusInp, PeriodicSidesThatP4estCouldNotDistinguishAreReported) {
  const QuadMesh mesh = periodic_row(2);
  const Exported exported = abaqus_inp(mesh, plane_frame(mesh.face));
  EXPECT_NE(exported.bytes.find("\n2, 2, 5, 6, 3\n"), std::string::npos);
  EXPECT_NE(exported.bytes.find("\n** left --- low high\n** --- right low high\n"), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("p4est identifies edges by their ends"), std::string::npos);
}

TEST(AbaqusInp, NamesAreWrittenInLettersThatReadersTake) {
  const QuadMesh mesh = two_quads();
  const Exported exported = abaqus_inp(mesh, plane_frame(mesh.face));
  ASSERT_EQ(exported.side_files.size(), 1u);
  EXPECT_EQ(exported.side_files[0].name.ending, ".names.json");
  EXPECT_EQ(exported.losses.size(), 2u);
}

}  // namespace
}  // namespace quadrille::exports
