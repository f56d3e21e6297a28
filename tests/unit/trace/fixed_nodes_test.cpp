#include "trace/fixed_nodes.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "../triangulate/faces.hpp"
#include "base/error.hpp"

namespace quadrille::trace {
namespace {

using namespace testing_faces;

CriticalPoint node(Vec2 x, int valence) { return {x, 4 - valence, valence, 0, {}, {}}; }

/// The lower side of the square is cut in two at a smooth joint, (0.5, 0): curves 0 and 1.
CadFace square_with_joint() {
  CadFace face = make_face({polygon({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}})});
  face.origin = {10, 20};
  return face;
}

std::string refusal(const CriticalPoints& points) {
  return message_of<ComputeError>([&] { fixed_nodes(square_with_joint(), points); });
}

TEST(FixedNodes, AreInnerOnesThenCornersThenThoseOnTheBoundary) {
  CriticalPoints points;
  points.boundary_nodes.push_back({3, 0.25, {0.75, 1}, 3, NodeSource::feature});
  points.corners.push_back({2, {1, 0}, 90, 1, {}});
  points.critical_points = {node({0.3, 0.4}, 3), node({0.6, 0.4}, 5)};
  const std::vector<graph::FixedNode> nodes = fixed_nodes(square_with_joint(), points);
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_EQ(nodes[0].kind, NodeKind::irregular);
  EXPECT_EQ(nodes[1].valence, 5);
  EXPECT_EQ(nodes[1].joint, -1);
  EXPECT_EQ(nodes[2].kind, NodeKind::corner);
  EXPECT_EQ(nodes[2].joint, 2);
  EXPECT_EQ(nodes[3].kind, NodeKind::boundary);
  EXPECT_EQ(nodes[3].curve, 3);
  EXPECT_EQ(nodes[3].joint, -1);
  EXPECT_EQ(positions(nodes), (std::vector<Vec2>{{0.3, 0.4}, {0.6, 0.4}, {1, 0}, {0.75, 1}}));
}

TEST(FixedNodes, ABoundaryNodeAtTheEndOfACurveIsItsJoint) {
  for (const auto& [curve, t] : {std::pair{0, 0.5}, {1, 0.0}, {1, 1e-14}}) {
    CriticalPoints points;
    points.boundary_nodes.push_back({curve, t, {}, 3, NodeSource::feature});
    const graph::FixedNode found = fixed_nodes(square_with_joint(), points).at(0);
    EXPECT_EQ(found.joint, 1) << curve;
    EXPECT_EQ(found.position, (Vec2{0.5, 0}));
  }
}

TEST(FixedNodes, TheLastCurveOfALoopEndsAtItsFirstJoint) {
  CriticalPoints points;
  points.boundary_nodes.push_back({4, 1, {}, 3, NodeSource::feature});
  EXPECT_EQ(fixed_nodes(square_with_joint(), points).at(0).joint, 0);
}

TEST(FixedNodes, NodesThatNoLayoutCanHaveAreRefusedWithTheirPlace) {
  CriticalPoints zero, corner, straight;
  zero.critical_points = {node({0.3, 0.4}, 2)};
  EXPECT_TRUE(contains(refusal(zero), "(10.3, 20.4) has index +2")) << refusal(zero);
  corner.corners.push_back({2, {1, 0}, 20, 0, {}});
  EXPECT_TRUE(contains(refusal(corner), "20.0 degrees at (11, 20)")) << refusal(corner);
  EXPECT_TRUE(contains(refusal(corner), "--degenerate divide"));
  straight.boundary_nodes.push_back({3, 0.25, {}, 1, NodeSource::feature});
  EXPECT_TRUE(contains(refusal(straight), "valence 1 on the smooth boundary at (10.75, 21)")) << refusal(straight);
}

TEST(FixedNodes, TheLeastValencesAreKept) {
  CriticalPoints points;
  points.critical_points = {node({0.3, 0.4}, 3)};
  points.corners.push_back({2, {1, 0}, 90, 1, {}});
  points.boundary_nodes.push_back({3, 0.25, {}, 3, NodeSource::feature});
  EXPECT_EQ(refusal(points), "");
}

}  // namespace
}  // namespace quadrille::trace
