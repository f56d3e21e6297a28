#include "refine/boundary_slide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

TEST(BoundarySlide, VerticesAtJointsAreFixedAndNoOthers) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.3, 3, 1e-3});
  const BoundarySlide boundary(mesh);
  EXPECT_EQ(boundary.vertices().size(), mesh.boundary_edges.size());
  int num_fixed = 0;
  for (const SlidingVertex& v : boundary.vertices()) {
    double gap = 1e300;
    for (const Joint& joint : mesh.face.joints) gap = std::min(gap, distance(joint.position, mesh.nodes[v.node]));
    EXPECT_EQ(v.is_fixed, gap < 1e-9);
    num_fixed += v.is_fixed;
  }
  EXPECT_EQ(num_fixed, 4);
}

TEST(BoundarySlide, StaysOnTheCircleAlsoAcrossItsSeam) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(3), {0.3, 4, 1e-4});
  const BoundarySlide boundary(mesh);
  for (int v = 0; v < static_cast<int>(boundary.vertices().size()); ++v) {
    const SlidingVertex& vertex = boundary.vertices()[v];
    EXPECT_FALSE(vertex.is_fixed) << "a circle has neither corners nor breaks";
    const double radius = vertex.loop == 0 ? 1 : 0.5;
    EXPECT_LT(distance(boundary.at(v, 0).position, mesh.nodes[vertex.node]), 1e-12);
    for (const double slide : {-0.05, 0.05}) {
      const curve::ChainPoint p = boundary.at(v, slide);
      EXPECT_NEAR(norm(p.position), radius, 1e-12);
      EXPECT_NEAR(distance(p.position, mesh.nodes[vertex.node]), 2 * radius * std::sin(0.025 / radius), 1e-10);
      EXPECT_NEAR(dot(p.tangent, p.position), 0, 1e-10);
    }
  }
}

TEST(BoundarySlide, AClosedCurveThatIsNotSmoothAtItsStartIsFixedThere) {
  QuadMesh mesh = refined(hand_made::cut_annulus(3), {0.3, 4, 1e-4});
  Nurbs& circle = mesh.face.curves[0];
  const Vec2 leg = circle.poles[1] - circle.poles[0];
  circle.poles[1] += 1e-3 * norm(leg) * unit(angle_of(leg) + half_pi);
  mesh.face.joints[0].interior_angle = pi - 1e-3;
  const BoundarySlide boundary(mesh);
  int num_at_start = 0;
  for (const SlidingVertex& v : boundary.vertices())
    if (distance(mesh.nodes[v.node], circle.poles[0]) < 1e-12) {
      ++num_at_start;
      EXPECT_TRUE(v.is_fixed);
    }
  EXPECT_EQ(num_at_start, 1);
}

TEST(BoundarySlide, EdgesGoFromVertexToVertexByArcLength) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(3), {0.3, 4, 1e-4});
  const BoundarySlide boundary(mesh);
  for (int e = 0; e < static_cast<int>(boundary.edges().size()); ++e) {
    const SlidingEdge& edge = boundary.edges()[e];
    const std::vector<Vec2> nodes = boundary.edge_nodes(e, -0.02, 0.03);
    ASSERT_EQ(nodes.size(), 5u);
    EXPECT_LT(distance(nodes.front(), boundary.at(edge.from, -0.02).position), 1e-12);
    EXPECT_LT(distance(nodes.back(), boundary.at(edge.to, 0.03).position), 1e-12);
    EXPECT_NEAR(distance(nodes[1], nodes[2]), distance(nodes[2], nodes[3]), 1e-10);
    EXPECT_GT(boundary.edge_error(e, -0.02, 0.03), boundary.edge_error(e, 0, 0)) << "longer is farther away";
    EXPECT_LT(boundary.edge_error(e, 0, 0), 1e-4 * mesh.face.diameter);
  }
}

TEST(BoundarySlide, EdgesThatPassAJointKeepTheirEnds) {
  // Coarse and lax: the long sides of the bend get edges that pass its joints.
  const QuadMesh mesh =
      refined(hand_made::elbow(), {.size = 1.3, .order = 4, .geometry_tol = 0.1, .relax = Relax::none});
  const BoundarySlide boundary(mesh);
  int num_passing = 0;
  for (const SlidingEdge& edge : boundary.edges())
    for (const Joint& joint : mesh.face.joints) {
      const SlidingVertex &from = boundary.vertices()[edge.from], &to = boundary.vertices()[edge.to];
      const Vec2 a = mesh.nodes[from.node], b = mesh.nodes[to.node];
      const bool is_between = std::min(distance(a, joint.position), distance(b, joint.position)) > 1e-6 &&
                              distance(a, joint.position) + distance(joint.position, b) < 1.1 * distance(a, b);
      if (!is_between) continue;
      ++num_passing;
      EXPECT_TRUE(from.is_fixed && to.is_fixed);
    }
  EXPECT_GT(num_passing, 0) << "else this shows nothing";
}

TEST(BoundarySlide, SmoothJointsHoldVerticesByTheirNames) {
  QuadMesh mesh = refined(hand_made::elbow(), {.size = 0.3, .order = 3, .geometry_tol = 1e-3, .relax = Relax::none});
  EXPECT_TRUE(BoundarySlide(mesh, SlidesOff::breaks).free_joints().empty());
  const std::vector<LoopJoint> joints = BoundarySlide(mesh, SlidesOff::joints).free_joints();
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_NEAR(joints[0].length, 1, 1e-9);
  EXPECT_NEAR(joints[1].length, 1 + pi + 1 + half_pi, 1e-9);
  hand_made::give_name(mesh.face, 1, "bend");
  EXPECT_EQ(BoundarySlide(mesh, SlidesOff::joints).free_joints().size(), 1u) << "a given name holds its ends";
  mesh.face.curve_names[4] = mesh.face.curve_names[3];
  EXPECT_TRUE(BoundarySlide(mesh, SlidesOff::joints).free_joints().empty()) << "one name on both sides";
}

}  // namespace
}  // namespace quadrille::refine
