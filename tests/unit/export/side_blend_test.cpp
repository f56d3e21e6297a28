#include "export/side_blend.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "export/edge_numbering.hpp"
#include "refine/refine.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(SideBlend, TellsHowFarTheMiddleWasMoved) {
  EXPECT_EQ(distance_from_side_blend(two_quads(), 0), 0);
  EXPECT_EQ(distance_from_side_blend(two_quads(), 1), 0);
  EXPECT_DOUBLE_EQ(distance_from_side_blend(two_quads_with_moved_middle(), 1), std::hypot(0.125, 0.25));
}

TEST(SideBlend, ElementsOfABlendedBlockAreBlends) {
  Report report;
  const QuadMesh mesh = refine::refine(block::extract_blocks(hand_made::elbow(), report), {0.4, 7, 5e-7}, report);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) EXPECT_LT(distance_from_side_blend(mesh, elem), 1e-14) << elem;
}

TEST(SideBlend, DistanceFromTheChordIsThatOfTheArcAndOfUnevenSpeed) {
  QuadMesh mesh = two_quads();
  const EdgeNumbering numbering = number_edges(mesh);
  EXPECT_DOUBLE_EQ(distance_from_chord(mesh, edge_nodes(mesh, numbering.edges[6])), 0.5);
  EXPECT_EQ(distance_from_chord(mesh, edge_nodes(mesh, numbering.edges[0])), 0);
  mesh.nodes[1].x = 1.25;
  EXPECT_DOUBLE_EQ(distance_from_chord(mesh, edge_nodes(mesh, numbering.edges[0])), 0.25);
}

}  // namespace
}  // namespace quadrille::exports
