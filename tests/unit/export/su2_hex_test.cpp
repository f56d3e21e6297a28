#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/split_hexes.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Su2Hex, ThePageShowsWhatIsWritten) {
  const Exported exported = su2_mesh(two_hexes_of_the_pages());
  EXPECT_NE(page("su2.md").find("```\n" + exported.bytes + "```\n"), std::string::npos) << exported.bytes;
  ASSERT_EQ(exported.losses.size(), 2u);
  EXPECT_EQ(exported.losses[0], "1 interface is not stored: \"between\"");
  EXPECT_EQ(exported.losses[1], "2 region names are not stored");
}

TEST(Su2Hex, EachElementIsCutBetweenItsNodes) {
  const HexMesh mesh = two_hexes({.order = 3, .layers = 2, .first_corner = 1, .map = bent});
  const HexMesh pieces = split_at_nodes(mesh);
  ASSERT_EQ(pieces.num_elems(), 4 * 27);
  EXPECT_EQ(pieces.num_layers(), 6);
  EXPECT_TRUE(pieces.is_valid);
  // The piece (2, 0, 1) of the second quad in the upper layer.
  const int elem = 3, piece = ((3 + 1) * 2 + 1) * 9 + 2;
  EXPECT_EQ(pieces.region_of(piece), 1);
  for (int local = 0; local < 8; ++local)
    EXPECT_EQ(pieces.elem_nodes[8 * piece + local],
              mesh.elem_nodes[64 * elem + ((1 + local / 4) * 4 + local / 2 % 2) * 4 + 2 + local % 2]);
  std::size_t faces = 0;
  for (const HexFaceGroup& group : pieces.face_groups) faces += group.elems.size();
  EXPECT_EQ(faces, 9u * (2 * 2 * 4 + 4));
}

/// Bounds of pieces are below det J everywhere, and close to it where edges are nearly parallel.
TEST(Su2Hex, BoundsOfPiecesAreBelowTheirDeterminants) {
  const HexMesh pieces = split_at_nodes(two_hexes({.order = 4, .map = bent}));
  double closest = 1e300;
  for (int elem = 0; elem < pieces.num_elems(); ++elem) {
    const auto node = [&](int k) { return pieces.nodes[pieces.elem_nodes[8 * elem + k]]; };
    double least = 1e300;
    for (int corner = 0; corner < 8; ++corner) {
      const auto edge = [&](int stride) { return node(corner | stride) - node(corner & ~stride); };
      least = std::min(least, dot(cross(edge(1), edge(2)), edge(4)) / 8);
    }
    EXPECT_GT(pieces.elem_jacobian_bound[elem], 0);
    EXPECT_LE(pieces.elem_jacobian_bound[elem], least);
    closest = std::min(closest, least / pieces.elem_jacobian_bound[elem]);
  }
  EXPECT_LT(closest, 1.2);
}

/// The faces of the pieces are those of the element, node for node.
TEST(Su2Hex, FacesOfPiecesLieOnTheFacesOfTheirElement) {
  const HexMesh mesh = two_hexes({.order = 2, .first_corner = 3}), pieces = split_at_nodes(mesh);
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g) {
    const HexFaceGroup &whole = mesh.face_groups[g], &split = pieces.face_groups[g];
    ASSERT_EQ(split.elems.size(), 4 * whole.elems.size());
    for (std::size_t k = 0; k < split.elems.size(); ++k) {
      std::vector<int> of_elem;
      for (const int local : hex_face_nodes(2, whole.faces[k / 4]))
        of_elem.push_back(mesh.elem_nodes[27 * whole.elems[k / 4] + local]);
      for (const int local : hex_face_nodes(1, split.faces[k]))
        EXPECT_NE(std::find(of_elem.begin(), of_elem.end(), pieces.elem_nodes[8 * split.elems[k] + local]),
                  of_elem.end());
    }
  }
}

/// z = 1 becomes the parabola 1 + x (4 - x) / 2, over two elements of length 2 and order 2: in the middle between its
/// nodes, at distances of 1, it is 1/8 above the straight lines, along z; the slopes of the lines are 3/2 and 1/2.
TEST(Su2Hex, TheLossIsTheDistanceFromTheCurvedFace) {
  HexMesh mesh = two_hexes({.order = 2, .map = [](Vec3 x) { return Vec3{x.x, x.y, x.z * (1 + x.x * (4 - x.x) / 2)}; }});
  mesh.diameter = 1;
  const double largest = 1.0 / 8 / std::hypot(1, 0.5);
  EXPECT_EQ(split_loss(mesh),
            fmt::format("elements have straight edges, which moves the boundary by up to {:.2g} ({:.2g} of the "
                        "diameter)",
                        largest, largest));
  EXPECT_EQ(split_loss(two_hexes({.order = 3})), "");
}

/// Of order 2 with det J > 0 everywhere but straight pieces that are folded is rare: a folded element stands for it.
TEST(Su2Hex, AFoldedCellIsRefused) {
  HexMesh mesh = two_hexes({.order = 2});
  mesh.nodes[mesh.elem_nodes[13]].z = 2;
  EXPECT_FALSE(split_at_nodes(mesh).is_valid);
  EXPECT_THROW(su2_mesh(mesh), ComputeError);
}

TEST(Su2Hex, PeriodicFacesAreReported) {
  HexMesh mesh = two_hexes({.order = 1});
  join_ends(mesh, 1);
  const std::vector<std::string> losses = su2_mesh(mesh).losses;
  EXPECT_NE(losses.back().find("periodic"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
