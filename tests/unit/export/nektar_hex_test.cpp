#include <gtest/gtest.h>

#include "export/hex_blend.hpp"
#include "export/hex_numbering.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(NektarHex, ThePageShowsWhatIsWritten) {
  EXPECT_NE(page("nektar.md").find("```xml\n" + nektar_xml(two_hexes_of_the_pages()).bytes + "```\n"),
            std::string::npos);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(NektarHex, OnlyWhatIsCurvedIsListed) {
  EXPECT_EQ(nektar_xml(two_hexes({.order = 3, .first_corner = 1})).bytes.find("CURVED"), std::string::npos);
  // z = 1 is raised to 1 + x^2 y (2 - y): straight sides at y = 0 and y = 2 stay, the top and the middle change.
  const auto raised = [](Vec3 x) { return Vec3{x.x, x.y, x.z * (1 + x.x * x.x * x.y * (2 - x.y) / 9)}; };
  const std::string text = nektar_xml(two_hexes({.order = 3, .first_corner = 2, .map = raised})).bytes;
  EXPECT_EQ(count(text, "FACEID="), 2u) << "both tops; upright faces are the blend of their sides";
  EXPECT_EQ(count(text, "EDGEID="), 7u) << "all edges of the tops";
  EXPECT_EQ(count(text, "NUMPOINTS=\"16\""), 2u);
}

TEST(NektarHex, ParallelEdgesRunInOneDirectionWhateverTheOrientationOfQuads) {
  for (int corner = 0; corner < 4; ++corner) {
    const HexMesh turned = turned_along_chords(two_hexes({.order = 3, .layers = 2, .first_corner = corner}));
    const HexNumbering numbering = number_directed_parts(turned);
    for (int elem = 0; elem < turned.num_elems(); ++elem)
      for (int edge = 0; edge < 12; ++edge) {
        const auto [from, to] = hex_edge_corners[edge];
        const NumberedEdge& numbered = numbering.edges[numbering.elem2edges[12 * elem + edge]];
        EXPECT_EQ(numbered.vertices, (std::array<int, 2>{numbering.vertex(elem, from), numbering.vertex(elem, to)}));
        EXPECT_EQ(edge_nodes(turned, elem, edge), edge_nodes(turned, numbered));
      }
  }
}

TEST(NektarHex, NodesInsideElementsAreLostWithTheirDistance) {
  HexMesh mesh = two_hexes({.order = 2});
  EXPECT_TRUE(nektar_xml(mesh).losses.empty());
  EXPECT_NEAR(face_blend_loss(mesh), 0, 1e-15);
  mesh.nodes[mesh.elem_nodes[13]].x += 0.125;  // the middle of the first element
  EXPECT_NEAR(face_blend_loss(mesh), 0.125, 1e-15);
  const Exported exported = nektar_xml(mesh);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("moves them by up to 0.12 (0.025 of the diameter)"), std::string::npos);
}

TEST(NektarHex, FacesOfPeriodicCompositesAreInTheOrderOfTheirPartners) {
  HexMesh mesh = two_hexes({.order = 2, .layers = 3});
  join_ends(mesh, 3);
  std::swap(mesh.face_groups[4].elems[0], mesh.face_groups[4].elems[1]);
  std::swap(mesh.face_groups[3].elems[0], mesh.face_groups[3].elems[1]);
  const Exported exported = nektar_xml(mesh);
  EXPECT_NE(exported.bytes.find("NAME=\"bottom\"> F[0,6] "), std::string::npos);
  EXPECT_NE(exported.bytes.find("NAME=\"top\"> F[24,28] "), std::string::npos);
  EXPECT_TRUE(exported.losses.empty());
  mesh.face_groups[0].name = "bottom";  // one composite of two groups
  EXPECT_EQ(nektar_xml(mesh).losses.size(), 1u);
}

}  // namespace
}  // namespace quadrille::exports
