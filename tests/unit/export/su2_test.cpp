#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Su2, OrderOneInFull) {
  const QuadMesh mesh = two_straight_quads();
  const Exported exported = su2_mesh(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes, R"(NDIME= 2
NELEM= 2
9 0 1 2 3 0
9 1 4 5 2 1
NPOIN= 6
0 0 0
2 0 1
2 2 2
0 2 3
4 0 4
4 2 5
NMARK= 3
MARKER_TAG= wall
MARKER_ELEMS= 4
3 0 1
3 1 4
3 5 2
3 2 3
MARKER_TAG= in___out
MARKER_ELEMS= 1
3 4 5
MARKER_TAG= curve_3
MARKER_ELEMS= 1
3 3 0
)");
  ASSERT_EQ(exported.losses.size(), 2u);
  EXPECT_EQ(exported.losses[0], "2 region names are not stored");
  EXPECT_EQ(exported.losses[1], "1 name is written in plain letters: \"in & out\" as in___out");
}

TEST(Su2, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const Exported exported = su2_mesh(mesh, plane_frame(mesh.face));
  EXPECT_NE(page("su2.md").find("```\n" + exported.bytes + "```\n"), std::string::npos) << exported.bytes;
}

TEST(Su2, AMarkerOfParallelRunsIsNotTaken) {
  QuadMesh mesh = two_straight_quads();
  mesh.face.curve_names = {"SEND_RECEIVE", "b", "c", "d"};
  EXPECT_NE(su2_mesh(mesh, plane_frame(mesh.face)).bytes.find("MARKER_TAG= SEND_RECEIVE_2\n"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
