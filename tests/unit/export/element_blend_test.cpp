#include "export/element_blend.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "export/edge_numbering.hpp"
#include "refine/refine.hpp"
#include "spectral/quadrature.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

/// One element of order n whose nodes are f(s, t), s and t in [0, 1].
template <class Map>
QuadMesh one_quad(int order, Map f) {
  QuadMesh mesh;
  mesh.order = order;
  mesh.face.diameter = 1;
  for (const double eta : spectral::gll_points(order))
    for (const double xi : spectral::gll_points(order)) {
      mesh.elem_nodes.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.push_back(f((1 + xi) / 2, (1 + eta) / 2));
    }
  mesh.elem_block = {0};
  return mesh;
}

/// Linear in t between two curved sides: a blend of its sides.
Vec2 ruled(double s, double t) { return {s + 0.1 * t * s * (1 - s), t + (1 - t) * s * s * s / 4}; }

TEST(TransfiniteLoss, BlendsOfTheirSidesLoseNothing) {
  for (const int order : {1, 2, 3, 6, 12}) {
    const QuadMesh mesh = order == 1 ? two_straight_quads() : one_quad(order, ruled);
    EXPECT_LT(transfinite_loss(mesh, RebuiltFrom::sides, "x").interior, 1e-15 * mesh.face.diameter) << order;
  }
  EXPECT_EQ(transfinite_loss(two_quads(), RebuiltFrom::sides, "x").interior, 0);
}

TEST(TransfiniteLoss, IsTheDistanceOfTheMovedNode) {
  const TransfiniteLoss loss = transfinite_loss(two_quads_with_moved_middle(), RebuiltFrom::sides, "x");
  EXPECT_DOUBLE_EQ(loss.interior, std::hypot(0.125, 0.25));
  EXPECT_EQ(loss.sides, 0);
}

TEST(TransfiniteLoss, ParabolasKeepOrderTwoAndMissOrderThree) {
  EXPECT_EQ(transfinite_loss(two_quads(), RebuiltFrom::quadratic_sides, "x").sides, 0);
  // y = s^3 / 4 against the parabola through s = 0, 1/2, 1: the difference s (s - 1/2) (s - 1) / 4 at the nodes.
  const double s = (1 + spectral::gll_points(3)[2]) / 2;
  EXPECT_NEAR(transfinite_loss(one_quad(3, ruled), RebuiltFrom::quadratic_sides, "x").sides,
              std::abs(s * (s - 0.5) * (s - 1) / 4), 1e-15);
}

TEST(TransfiniteLoss, RefusesWhatTheReaderWouldFold) {
  // The lower side reaches over the upper one, so that the blend of the sides has negative Jacobians.
  const QuadMesh folded = one_quad(4, [](double s, double t) {
    return Vec2{s, t * 0.1 + 8 * s * (1 - s) * s * (1 - s) * (1 - t)};
  });
  EXPECT_NO_THROW(
      transfinite_loss(folded, RebuiltFrom::sides, "x"));  // the mesh's own element, which its bounds have judged
  QuadMesh moved = folded;
  moved.nodes[12].y += 0.01;
  try {
    transfinite_loss(moved, RebuiltFrom::sides, "Reader");
    FAIL();
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("Reader rebuilds"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("element 0 near"), std::string::npos);
  }
}

TEST(SideBlend, TellsHowFarTheMiddleWasMoved) {
  EXPECT_EQ(distance_from_side_blend(two_quads(), 0), 0);
  EXPECT_EQ(distance_from_side_blend(two_quads(), 1), 0);
  EXPECT_DOUBLE_EQ(distance_from_side_blend(two_quads_with_moved_middle(), 1), std::hypot(0.125, 0.25));
}

TEST(SideBlend, ElementsOfABlendedBlockAreBlends) {
  Report report;
  refine::RefineOptions options{0.4, 7, 5e-7};
  options.inner_edges = refine::InnerEdges::curved;  // straight ones are blended by (1 - eta)^2
  const QuadMesh mesh = refine::refine(block::extract_blocks(hand_made::elbow(), report), options, report);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) EXPECT_LT(distance_from_side_blend(mesh, elem), 1e-14) << elem;
}

TEST(SideBlend, AnArcAndUnevenSpeedAreNotStraight) {
  QuadMesh mesh = two_quads();
  const EdgeNumbering numbering = number_edges(mesh);
  EXPECT_FALSE(is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[6])));
  EXPECT_TRUE(is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[0])));
  mesh.nodes[1].x = 1.25;
  EXPECT_FALSE(is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[0])));
}

}  // namespace

}  // namespace quadrille::exports
