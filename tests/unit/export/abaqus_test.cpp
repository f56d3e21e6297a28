#include <gtest/gtest.h>

#include <sstream>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Abaqus, OrderOneInFull) {
  const QuadMesh mesh = two_straight_quads();
  const Exported exported = abaqus_cpe(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes, R"(*HEADING
quadrilaterals of order 1
*NODE, NSET=NALL
1, 0, 0, 0
2, 2, 0, 0
3, 2, 2, 0
4, 0, 2, 0
5, 4, 0, 0
6, 4, 2, 0
*ELEMENT, TYPE=CPE4, ELSET=left
1, 1, 2, 3, 4
*ELEMENT, TYPE=CPE4, ELSET=right
2, 2, 5, 6, 3
*ELSET, ELSET=EALL
left
right
*NSET, NSET=wall
1, 2, 3, 4, 5, 6
*SURFACE, NAME=wall, TYPE=ELEMENT
1, S1
2, S1
2, S3
1, S3
*NSET, NSET=in___out
5, 6
*SURFACE, NAME=in___out, TYPE=ELEMENT
2, S2
*NSET, NSET=curve_3
1, 4
*SURFACE, NAME=curve_3, TYPE=ELEMENT
1, S4
)");
}

TEST(Abaqus, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const Exported exported = abaqus_cps(mesh, plane_frame(mesh.face));
  EXPECT_NE(page("calculix.md").find("```\n" + exported.bytes + "```\n"), std::string::npos) << exported.bytes;
  EXPECT_TRUE(exported.losses.empty());
}

TEST(Abaqus, MiddlesThatSidesDoNotTellAreReported) {
  const QuadMesh mesh = two_quads_with_moved_middle();
  const Exported exported = abaqus_cps(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.losses.at(0),
            "nodes in the middle of elements are not stored, which moves these middles by up to 0.28 (0.056 of the "
            "diameter)");
}

TEST(Abaqus, NumbersHaveAtMostTwentyCharacters) {
  QuadMesh mesh = two_straight_quads();
  mesh.nodes[0] = {-1.2345678901234567e-101, -0.12345678901234568};
  const std::string text = abaqus_cps(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("\n1, -1.234567890123e-101, -0.12345678901234568, 0\n"), std::string::npos) << text;
  std::istringstream lines(text);
  for (std::string word; lines >> word;) EXPECT_LE(word.size(), 21u) << word;  // with the comma
}

TEST(Abaqus, OrderFourIsFourElementsOfOrderTwo) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.5, 4});
  const std::string text = abaqus_cps(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("CPS8"), std::string::npos);
  EXPECT_NE(text.find(fmt::format("\n{}, ", 4 * mesh.num_elems())), std::string::npos);
}

TEST(Abaqus, RadiiOfAxisymmetricElementsAreNotNegative) {
  QuadMesh mesh = two_straight_quads();
  EXPECT_NO_THROW(abaqus_cax(mesh, plane_frame(mesh.face)));
  for (Vec2& x : mesh.nodes) x.x -= 3;
  try {
    abaqus_cax(mesh, plane_frame(mesh.face));
    FAIL() << "written";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("x = -3"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace quadrille::exports
