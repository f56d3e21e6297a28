#include "export/skeleton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::exports {
namespace {

/// Each curve's edges follow each other from its first point to its last.
void expect_walks(const QuadMesh& mesh, const Skeleton& skeleton) {
  for (const SkeletonCurve& curve : skeleton.curves) {
    int at = skeleton.points[curve.from];
    for (const SkeletonEdge& e : curve.edges) {
      EXPECT_EQ(side_start(mesh, e.elem, e.side), at);
      EXPECT_EQ(mesh.elem_block[e.elem], curve.blocks[0]);
      at = side_nodes(mesh, e.elem, e.side).back();
    }
    EXPECT_EQ(at, skeleton.points[curve.to]);
  }
}

TEST(Skeleton, OfTheLIsItsLayout) {
  const SeparatrixGraph graph = hand_made::l_shape();
  const QuadMesh mesh = refined(graph, {0.25, 3, 5e-7});
  const Skeleton skeleton = mesh_skeleton(mesh);
  EXPECT_EQ(skeleton.points.size(), graph.nodes.size());
  EXPECT_EQ(skeleton.curves.size(), graph.arcs.size());
  EXPECT_EQ(
      std::count_if(skeleton.curves.begin(), skeleton.curves.end(), [](const auto& c) { return c.cad_curve < 0; }), 2);
  expect_walks(mesh, skeleton);
}

TEST(Skeleton, InterfaceHasBothItsBlocks) {
  for (const SkeletonCurve& curve : mesh_skeleton(refined(hand_made::cut_annulus(4), {0.2, 2, 5e-7})).curves) {
    EXPECT_GE(curve.blocks[0], 0);
    EXPECT_EQ(curve.blocks[1] >= 0, curve.cad_curve < 0);
    EXPECT_NE(curve.blocks[0], curve.blocks[1]);
  }
}

TEST(Skeleton, ClosedCurvesStartAndEndInOnePoint) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(1), {0.3, 2, 5e-7});
  const Skeleton skeleton = mesh_skeleton(mesh);
  ASSERT_EQ(skeleton.curves.size(), 2u);  // a block's cut through itself is no interface
  for (const SkeletonCurve& curve : skeleton.curves) EXPECT_EQ(curve.from, curve.to);
  expect_walks(mesh, skeleton);
}

TEST(Skeleton, JointsInsideASideAreEnds) {
  const QuadMesh mesh = refined(hand_made::elbow(), {0.5, 4, 5e-7});
  const Skeleton skeleton = mesh_skeleton(mesh);
  EXPECT_EQ(skeleton.curves.size(), 6u);  // one for each CAD curve
  EXPECT_EQ(skeleton.points.size(), 6u);
  expect_walks(mesh, skeleton);
}

TEST(Skeleton, EdgesCoverTheBoundaryOnce) {
  const QuadMesh mesh = refined(hand_made::l_shape(), {0.3, 1, 5e-7});
  std::set<std::pair<int, int>> edges;
  for (const SkeletonCurve& curve : mesh_skeleton(mesh).curves)
    if (curve.cad_curve >= 0) {
      for (const SkeletonEdge& e : curve.edges) EXPECT_TRUE(edges.insert({e.elem, e.side}).second);
    }
  EXPECT_EQ(edges.size(), mesh.boundary_edges.size());
}

}  // namespace
}  // namespace quadrille::exports
