#include <gtest/gtest.h>

#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(InpHex, ThePageShowsWhatIsWritten) {
  EXPECT_NE(page("abaqus.md").find("```\n" + abaqus_inp(two_hexes_of_the_pages()).bytes + "```\n"), std::string::npos);
}

TEST(InpHex, FacesThatAreNotBilinearHaveTheirPointsInTrixisOrder) {
  const auto raised = [](Vec3 x) { return Vec3{x.x, x.y, x.z * (1 + x.x * (4 - x.x) * (2 - x.y) / 32)}; };
  const std::string text = abaqus_inp(two_hexes({.order = 2, .map = raised})).bytes;
  // The edge y = 0, z = 1 is curved: the faces -y and +z are. Points of -y: x fastest, then z.
  EXPECT_NE(text.find("\n**  1 2 3 4 5 6 7 8\n**  1 0 0 0 1 0\n**  0 0 0\n**  1 0 0\n**  2 0 0\n**  0 0 0.5\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\n**  0 0 1\n**  1 0 1.1875\n**  2 0 1.25\n**  0 0 1\n"), std::string::npos)
      << "the end of -y, the beginning of +z";
}

TEST(InpHex, FacesThatAreMovedOntoEachOtherAreOne) {
  HexMesh mesh = two_hexes({.order = 1, .layers = 3});
  join_ends(mesh, 3);
  const Exported exported = abaqus_inp(mesh);
  EXPECT_NE(exported.bytes.find("\n5, 13, 14, 15, 16, 1, 2, 3, 4\n"), std::string::npos) << exported.bytes;
  EXPECT_NE(exported.bytes.find("\n**  13 14 15 16 19 20 21 22\n"), std::string::npos) << exported.bytes;
  EXPECT_EQ(exported.bytes.find("bottom"), std::string::npos);
  EXPECT_NE(exported.losses.back().find("same corners in *ELEMENT"), std::string::npos);
  mesh.face_groups[3].periodic_with = -1;
  EXPECT_NE(abaqus_inp(mesh).bytes.find("bottom"), std::string::npos);
}

TEST(InpHex, NodesInsideElementsAreLostWithTheirDistance) {
  HexMesh mesh = two_hexes({.order = 2});
  mesh.nodes[mesh.elem_nodes[13]].x += 0.125;
  EXPECT_NE(abaqus_inp(mesh).losses.back().find("moves them by up to 0.12 "), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
