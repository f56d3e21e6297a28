#include "export/hex_numbering.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/error.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

TEST(HexNumbering, EveryEdgeAndFaceIsCountedOnceWhateverItsOrientation) {
  for (int order = 1; order <= 3; ++order)
    for (int corner = 0; corner < 4; ++corner) {
      const HexMesh mesh = two_hexes({.order = order, .layers = 2, .first_corner = corner});
      const HexNumbering numbering = number_parts(mesh);
      EXPECT_EQ(numbering.num_vertices(), 18);
      EXPECT_EQ(numbering.num_edges(), 3 * 7 + 2 * 6);
      EXPECT_EQ(numbering.num_faces(), 3 * 2 + 2 * 7);
      int inner = 0;
      for (const NumberedHexFace& face : numbering.faces) {
        if (face.other_elem < 0) continue;
        ++inner;
        const std::vector<int> one = face_nodes(mesh, face.elem, face.face),
                               other = face_nodes(mesh, face.other_elem, face.other_face);
        EXPECT_EQ(std::set<int>(one.begin(), one.end()), std::set<int>(other.begin(), other.end()));
      }
      EXPECT_EQ(inner, 4);
    }
}

TEST(HexNumbering, EdgesRunFromTheLowerVertex) {
  const HexMesh mesh = two_hexes({.order = 3, .first_corner = 2});
  const HexNumbering numbering = number_parts(mesh);
  for (const NumberedEdge& edge : numbering.edges) {
    const std::vector<int> nodes = edge_nodes(mesh, edge);
    EXPECT_LT(edge.vertices[0], edge.vertices[1]);
    EXPECT_EQ(nodes.front(), numbering.vertices[edge.vertices[0]]);
    EXPECT_EQ(nodes.back(), numbering.vertices[edge.vertices[1]]);
  }
}

TEST(HexNumbering, CornersOfFacesAreThoseOfTheirNodes) {
  const HexMesh mesh = two_hexes({.order = 3, .map = bent});
  for (int face = 0; face < 6; ++face) {
    const std::vector<int> nodes = local_face_nodes(3, hex_face_corners[face]);
    const std::array<int, 4> corners{nodes[0], nodes[3], nodes[15], nodes[12]};
    for (int k = 0; k < 4; ++k) EXPECT_EQ(corners[k], hex_corner_node(3, hex_face_corners[face][k]));
    Vec3 middle, centre;
    for (const int node : nodes) middle += mesh.nodes[mesh.elem_nodes[node]] / 16;
    for (int k = 0; k < 64; ++k) centre += mesh.nodes[mesh.elem_nodes[k]] / 64;
    const auto at = [&](int k) { return mesh.nodes[mesh.elem_nodes[nodes[k]]]; };
    EXPECT_GT(dot(cross(at(3) - at(0), at(12) - at(0)), middle - centre), 0) << "outwards";
  }
}

TEST(HexNumbering, EdgesThatJoinTheSameVerticesAreRefused) {
  HexMesh mesh = two_hexes({.order = 2});
  EXPECT_NO_THROW(require_known_by_vertices(mesh, number_parts(mesh), "MFEM"));
  // The second element ends where the first one begins: a ring whose elements have the same eight corners.
  for (int& node : mesh.elem_nodes)
    if (node % 5 == 4) node -= 4;
  try {
    require_known_by_vertices(mesh, number_parts(mesh), "MFEM");
    FAIL();
  } catch (const ComputeError& e) {
    EXPECT_NE(std::string(e.what()).find("two edges at (0, 0, 0) join the same vertices, and MFEM"), std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace quadrille::exports
