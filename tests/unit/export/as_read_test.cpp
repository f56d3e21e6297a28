#include "export/as_read.hpp"

#include <gtest/gtest.h>

#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

const ExportFormat& format(const char* name) { return *find_export_format(name); }

TEST(AsRead, FormatsOfCurvedElementsKeepAllNodes) {
  const QuadMesh mesh = two_quads_with_moved_middle();
  EXPECT_EQ(as_read(mesh, format("mfem")).nodes, mesh.nodes);
  const QuadMesh pieces = as_read(mesh, format("exodus"));
  EXPECT_EQ(pieces.nodes[pieces.elem_nodes[9 + 4]], mesh.nodes[8]);
  const HexMesh hexes = two_hexes({.order = 2, .map = bent});
  EXPECT_EQ(as_read(hexes, format("nektar")).nodes, hexes.nodes);
}

TEST(AsRead, NodesInsideQuadsAreTheBlendOfTheSidesWhereTheFormatHasNone) {
  const QuadMesh mesh = two_quads_with_moved_middle();
  for (const char* const name : {"ism-v2", "inp", "abaqus"}) {
    const QuadMesh read = as_read(mesh, format(name));
    // Half the sum of the sides' middles less a quarter of that of the corners: (3, 1.25).
    const Vec2 middle = read.nodes[read.elem_nodes[9 + 4]];
    EXPECT_NEAR(middle.x, 3, 1e-15) << name;
    EXPECT_NEAR(middle.y, 1.25, 1e-15) << name;
  }
}

TEST(AsRead, NodesInsideHexahedraAreBlendsOfFacesOrOfEdges) {
  const HexMesh mesh = two_hexes({.order = 2, .map = bent});
  const auto node = [](const HexMesh& hexes, int k) { return hexes.nodes[hexes.elem_nodes[k]]; };
  const HexMesh by_faces = as_read(mesh, format("inp")), by_edges = as_read(mesh, format("abaqus"));
  int num_moved = 0;
  for (int k = 0; k < 27; ++k) {
    const int num_inner = (k % 3 == 1) + (k / 3 % 3 == 1) + (k / 9 == 1);
    const bool is_moved = distance(node(by_edges, k), node(mesh, k)) > 1e-5;
    num_moved += is_moved ? 1 : 0;
    EXPECT_FALSE(num_inner <= 1 && is_moved) << k;
    EXPECT_TRUE(num_inner == 3 || node(by_faces, k) == node(mesh, k)) << k;
  }
  EXPECT_EQ(num_moved, 5);  // on y = const the map is f(x) + g(z), which is its own blend
  // Of serendipity elements the middle is a quarter of the sum of the edges' middles less a quarter of the corners'.
  Vec3 middle;
  for (int k = 0; k < 27; ++k) {
    const int num_inner = (k % 3 == 1) + (k / 3 % 3 == 1) + (k / 9 == 1);
    if (num_inner == 1) middle += 0.25 * node(mesh, k);
    if (num_inner == 0) middle -= 0.25 * node(mesh, k);
  }
  EXPECT_LT(distance(node(by_edges, 13), middle), 1e-14);
}

TEST(AsRead, PiecesKnowTheElementThatTheyAreOf) {
  const QuadMesh mesh = two_quads();
  const QuadMesh pieces = as_read(mesh, format("su2"));
  ASSERT_EQ(pieces.num_elems(), 8);
  EXPECT_EQ(source_element(mesh, pieces, 3), 0);
  EXPECT_EQ(source_element(mesh, pieces, 4), 1);
  const HexMesh hexes = two_hexes({.order = 2, .layers = 2});
  const HexMesh small = as_read(hexes, format("su2"));
  ASSERT_EQ(small.num_elems(), 32);
  for (int piece = 0; piece < 32; ++piece) {
    double x = 0, z = 0;
    for (int k = 0; k < 8; ++k) {
      const Vec3 corner = small.nodes[small.elem_nodes[8 * piece + k]];
      x += corner.x / 8, z += corner.z / 8;
    }
    EXPECT_EQ(source_element(hexes, small, piece), (z > 1 ? 2 : 0) + (x > 2 ? 1 : 0)) << piece;
  }
}

}  // namespace
}  // namespace quadrille::exports
