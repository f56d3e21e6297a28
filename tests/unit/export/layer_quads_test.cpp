#include "export/layer_quads.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

TEST(LayerQuads, AreThoseBelowTheFirstLayer) {
  const QuadMesh quads = quads_of_layer(two_hexes({.order = 2, .layers = 3}));
  EXPECT_EQ(quads.num_elems(), 2);
  EXPECT_EQ(quads.nodes.size(), 15u);
  EXPECT_EQ(quads.elem_nodes[2], quads.elem_nodes[9]) << "they share their nodes";
  EXPECT_EQ(quads.block_names, (std::vector<std::string>{"fluid", "solid"}));
  EXPECT_EQ(quads.boundary_edges.size(), 6u);
  EXPECT_EQ(quads.interface_edges.size(), 2u) << "from both sides";
  for (const QuadBoundaryEdge& edge : quads.interface_edges) EXPECT_EQ(quads.face.curve_names[edge.curve], "between");
}

TEST(LayerQuads, SidesOfATurnedQuadAreItsOwn) {
  const QuadMesh quads = quads_of_layer(two_hexes({.first_corner = 1}));
  for (const QuadBoundaryEdge& edge : quads.boundary_edges)
    if (quads.face.curve_names[edge.curve] == "outlet") {
      EXPECT_EQ(edge.elem, 1);
      EXPECT_EQ(edge.side, 0) << "of the side 1 of a quad that begins at its first corner";
    }
}

TEST(LayerQuads, NamesThatChangeFromLayerToLayerAreRefused) {
  HexMesh mesh = two_hexes({.layers = 2});
  for (std::size_t k = 0; k < mesh.face_groups[1].elems.size(); ++k)  // "outlet", in the upper layer "wall"
    if (mesh.face_groups[1].elems[k] >= 2) {
      mesh.face_groups[0].elems.push_back(mesh.face_groups[1].elems[k]);
      mesh.face_groups[0].faces.push_back(mesh.face_groups[1].faces[k]);
      mesh.face_groups[1].elems.pop_back(), mesh.face_groups[1].faces.pop_back();
    }
  EXPECT_EQ(message_of<ComputeError>([&] { quads_of_layer(mesh); }),
            "face 1 of hexahedron 3 is called wall, and another layer has no such side there: grids need sides of one "
            "name from bottom to top");
}

}  // namespace
}  // namespace quadrille::exports
