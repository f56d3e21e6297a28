#include "export/split_hexes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "spectral/hex_map.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

TEST(SplitHexes, OfOrderNAreNCubedPiecesInLayers) {
  const HexMesh mesh = two_hexes({.order = 3, .layers = 2});
  const HexMesh pieces = split_at_nodes(mesh);
  EXPECT_EQ(pieces.order, 1);
  EXPECT_EQ(pieces.num_elems(), 4 * 27);
  EXPECT_EQ(pieces.num_quads, 2 * 9);
  EXPECT_EQ(pieces.num_layers(), 6);
  EXPECT_TRUE(pieces.is_valid);
  EXPECT_EQ(pieces.nodes, mesh.nodes);
  for (int e = 0; e < pieces.num_elems(); ++e) {  // each piece lies in the layer and in the region that its number has
    Vec3 middle;
    for (int k = 0; k < 8; ++k) middle += pieces.nodes[pieces.elem_nodes[8 * e + k]] / 8;
    const double z = spectral::gll_points(3)[e / 18 % 3], above = spectral::gll_points(3)[e / 18 % 3 + 1];
    EXPECT_NEAR(middle.z, e / 54 + (2 + z + above) / 4, 1e-14);
    EXPECT_EQ(pieces.region_of(e), middle.x < 2 ? 0 : 1);
  }
}

TEST(SplitHexes, GroupsHaveAllPiecesAlongTheirFaces) {
  const HexMesh mesh = two_hexes({.order = 2, .layers = 2, .first_corner = 1});
  const HexMesh pieces = split_at_nodes(mesh);
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g) {
    const HexFaceGroup &whole = mesh.face_groups[g], &split = pieces.face_groups[g];
    EXPECT_EQ(split.elems.size(), 4 * whole.elems.size()) << whole.name;
    double area = 0;
    for (std::size_t k = 0; k < split.elems.size(); ++k) {
      const auto node = [&](int i) {
        return pieces.nodes[pieces.elem_nodes[8 * split.elems[k] + hex_face_nodes(1, split.faces[k])[i]]];
      };
      area += norm(cross(node(1) - node(0), node(2) - node(0)));
    }
    // "wall": four sides 2 x 2 and the left one; "between" from both sides.
    EXPECT_NEAR(area, (std::array<double, 5>{4 * 4 + 4, 4, 2 * 4, 8, 8}[g]), 1e-12) << whole.name;
  }
}

/// Of a parallelepiped the bound is its determinant, but for rounding.
TEST(SplitHexes, BoundsAreThoseOfThePieces) {
  const HexMesh straight = split_at_nodes(two_hexes({}));
  EXPECT_NEAR(straight.least_jacobian_bound, 2 * 2 * 1 / 8.0, 1e-12);
  const HexMesh pieces = split_at_nodes(two_hexes({.order = 3, .map = bent}));
  for (int e = 0; e < pieces.num_elems(); ++e) {
    std::vector<Vec3> nodes;
    for (int k = 0; k < 8; ++k) nodes.push_back(pieces.nodes[pieces.elem_nodes[8 * e + k]]);
    double least = 1e300;  // det J of a trilinear map at its corners
    for (int k = 0; k < 8; ++k) {
      const auto edge = [&](int stride) {
        return (k & stride) != 0 ? nodes[k] - nodes[k - stride] : nodes[k + stride] - nodes[k];
      };
      least = std::min(least, dot(cross(edge(1), edge(2)), edge(4)) / 8);
    }
    EXPECT_GT(pieces.elem_jacobian_bound[e], 0);
    EXPECT_LE(pieces.elem_jacobian_bound[e], least * (1 + 1e-9)) << e;
  }
}

TEST(SplitHexes, AFoldedPieceIsRefusedWithThePlace) {
  const HexMesh pieces = split_at_nodes(two_hexes({.map = [](Vec3 x) { return Vec3{x.x == 0 ? 3 : x.x, x.y, x.z}; }}));
  EXPECT_FALSE(pieces.is_valid);
  EXPECT_EQ(message_of<ComputeError>([&] { require_valid_pieces(pieces, "SU2's cells"); }),
            "SU2's cells have straight edges, and one near (2.5, 1, 0.5) would be folded; refine the mesh");
  EXPECT_NO_THROW(require_valid_pieces(split_at_nodes(two_hexes({})), "SU2's cells"));
}

/// The top z = 1 + h x (4 - x) / 4 of order 2 has nodes at x = 0, 1, 2, 3, 4; between them it is h / 16 off.
TEST(SplitLoss, IsTheDistanceOfTheBoundaryAcrossTheStraightPieces) {
  EXPECT_EQ(split_loss(two_hexes({.order = 3, .layers = 2})), "");
  const double h = 1e-3;
  const std::string loss = split_loss(two_hexes({.order = 2, .map = [&](Vec3 x) {
                                                   return Vec3{x.x, x.y, x.z * (1 + h * x.x * (4 - x.x) / 4)};
                                                 }}));
  EXPECT_TRUE(loss.starts_with("elements have straight edges, which moves the boundary by up to 6.2")) << loss;
}

/// Points may be elsewhere along a plane without moving it.
TEST(SplitLoss, CountsWhatIsNormalToThePieces) {
  EXPECT_EQ(split_loss(two_hexes({.order = 2,
                                  .map =
                                      [](Vec3 x) {
                                        return Vec3{x.x + 0.05 * x.x * (4 - x.x), x.y, x.z};
                                      }})),
            "");
}

}  // namespace
}  // namespace quadrille::exports
