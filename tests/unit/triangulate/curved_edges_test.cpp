#include "triangulate/curved_edges.hpp"

#include <gtest/gtest.h>

#include "curve/chain.hpp"
#include "faces.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::triangulate {
namespace {

/// Compares with ArcLength at many fractions.
void expect_same_as_arc_length(const Nurbs& curve, double t0, double t1) {
  const curve::ArcLength exact(curve);
  const ArcLengthTable stretch(curve, t0, t1);
  const double s0 = exact.at(t0), s1 = exact.at(t1);
  EXPECT_NEAR(stretch.length(), s1 - s0, 1e-13 * exact.total());
  for (int i = 0; i <= 20; ++i)
    EXPECT_NEAR(exact.at(stretch.parameter(i / 20.0)), s0 + (s1 - s0) * i / 20, 2e-14 * exact.total());
}

TEST(ArcLengthTable, OfACircle) {
  const Nurbs arc = curve::circular_arc({0, 0}, 2, 0, 2 * pi);
  expect_same_as_arc_length(arc, arc.begin(), arc.end());
  expect_same_as_arc_length(arc, 0.3, 0.9);
  expect_same_as_arc_length(arc, 1.2, 4.9);  // across knots at which the speed is not smooth
}

TEST(ArcLengthTable, OfASegmentIsLinear) {
  const ArcLengthTable stretch(curve::segment({0, 0}, {4, 0}), 1, 3);
  EXPECT_EQ(stretch.length(), 2);
  EXPECT_NEAR(stretch.parameter(0.25), 1.5, 1e-15);
}

TEST(ArcLengthTable, OfACurveWhoseSpeedNearlyVanishes) {
  const Nurbs hook{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {1, 0}, {0.01, 0.02}, {1, 1}}, {1, 1, 1, 1}};
  expect_same_as_arc_length(hook, 0, 1);
}

TEST(ArcLengthTable, EndsAreExact) {
  const Nurbs arc = curve::circular_arc({0, 0}, 1, 0, 2);
  const ArcLengthTable stretch(arc, 0.7, 1.9);
  EXPECT_EQ(stretch.parameter(0), 0.7);
  EXPECT_EQ(stretch.parameter(1), 1.9);
}

using namespace testing_faces;

TEST(EdgeFit, TurnIsTheSumOfAbsoluteTurns) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  const EdgeFit fit(outline, 4);
  EXPECT_NEAR(fit.turn(1, face.curves[1].begin(), face.curves[1].end()), pi, 1e-12);
  EXPECT_EQ(fit.turn(0, 0, 2), 0);
}

TEST(EdgeFit, NodesLieOnTheCircleAtLobattoFractionsOfTheLength) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  const auto nodes = EdgeFit(outline, 4).inner_nodes(1, face.curves[1].begin(), face.curves[1].end());
  ASSERT_EQ(nodes.size(), 3u);
  for (const Vec2 x : nodes) EXPECT_NEAR(norm(x), 1, 1e-15);
  EXPECT_NEAR(angle_of(nodes[0]), half_pi * (1 - std::sqrt(3.0 / 7)), 1e-14);
  EXPECT_NEAR(angle_of(nodes[1]), half_pi, 1e-14);
}

TEST(EdgeFit, ErrorOfOrderEightOnACircle) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  const curve::ArcLength& length = outline.arc_length(1);
  const EdgeFit fit(outline, 8);
  const double error45 = fit.error(1, 0, length.parameter(pi / 4)), error90 = fit.error(1, 0, length.parameter(pi / 2));
  EXPECT_LT(error45, 1e-12);  // known: 8e-13 of the radius
  EXPECT_GT(error45, 1e-13);
  EXPECT_GT(error90, 200 * error45);
}

TEST(EdgeFit, AStraightEdgeHasNoError) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  EXPECT_LT(EdgeFit(outline, 8).error(0, 0.1, 1.7), 1e-15);
}

/// The quarter disc as ONE element with a curved edge 1, of order 8.
struct QuarterDisc {
  QuarterDisc() {
    mesh.face = face;
    mesh.order = 8;
    mesh.vertices = {{0, 0}, {1, 0}, {0, 1}};
    mesh.elem2vertices = {{0, 1, 2}};
    mesh.boundary_edges = {{0, 0, 0, 0, 1}, {0, 1, 1, 0, face.curves[1].end()}, {0, 2, 2, 0, 1}};
    curve_elements(fit, mesh);
  }
  CadFace face = make_face(
      {{curve::segment({0, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, half_pi), curve::segment({0, 1}, {0, 0})}});
  Outline outline{face, 1e-13};
  EdgeFit fit{outline, 8};
  TriMesh mesh;
};

TEST(CurveElements, TheCurvedEdgeFollowsTheCurveAndTheOthersStayStraight) {
  const QuarterDisc quarter;
  ASSERT_EQ(quarter.mesh.curved_elems, std::vector<int>{0});
  const spectral::TriMap map(8, quarter.mesh.curved_nodes.data());
  for (int i = 0; i <= 20; ++i) {
    const double s = i / 20.0;
    EXPECT_NEAR(norm(map.position(spectral::tri_edge_point(1, s))), 1, 1e-9);  // order 8 over 90 degrees
    EXPECT_NEAR(distance(map.position(spectral::tri_edge_point(0, s)), {s, 0}), 0, 1e-14);
    EXPECT_NEAR(distance(map.position(spectral::tri_edge_point(2, s)), {0, 1 - s}), 0, 1e-14);
  }
}

TEST(CurveElements, AMirroredElementHasMirroredNodes) {
  const QuarterDisc quarter;
  const spectral::TriMap map(8, quarter.mesh.curved_nodes.data());
  for (const Vec2 xi : {Vec2{-0.5, -0.2}, Vec2{0.1, -0.7}, Vec2{-0.9, 0.6}}) {
    const Vec2 a = map.position(xi), b = map.position({xi.y, xi.x});
    EXPECT_NEAR(a.x, b.y, 1e-14);
    EXPECT_NEAR(a.y, b.x, 1e-14);
  }
}

TEST(CurveElements, TheProofHoldsAndIsBelowTheLeastSample) {
  const QuarterDisc quarter;
  const double bound = jacobian_ratio_bounds(quarter.mesh).front();
  EXPECT_GT(bound, 0.1);
  const spectral::TriMap map(8, quarter.mesh.curved_nodes.data());
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10 - i; ++j) {
      Vec2 x;
      Mat2 dx_dxi;
      map.evaluate({-1 + 0.2 * i, -1 + 0.2 * j}, x, dx_dxi);
      EXPECT_GE(det(dx_dxi) * 4 + 1e-12, bound);
    }
  }
}

TEST(CurveElements, AnElementThatItsCurveRunsThroughIsNotProved) {
  // The arc of a round hole passes beyond the element's third vertex.
  const Vec2 apex{0.6, 0.6};
  const CadFace face = make_face(
      {{curve::circular_arc({0, 0}, 1, half_pi, 0), curve::segment({1, 0}, apex), curve::segment(apex, {0, 1})}});
  const Outline outline(face, 1e-13);
  TriMesh mesh;
  mesh.order = 8;
  mesh.vertices = {{0, 1}, {1, 0}, apex};
  mesh.elem2vertices = {{0, 1, 2}};
  mesh.boundary_edges = {{0, 0, 0, 0, face.curves[0].end()}};
  curve_elements(EdgeFit(outline, 8), mesh);
  EXPECT_LE(jacobian_ratio_bounds(mesh).front(), 0);
}

TEST(CurveElements, OfOrderOneAreNone) {
  QuarterDisc quarter;
  quarter.mesh.order = 1;
  curve_elements(EdgeFit(quarter.outline, 1), quarter.mesh);
  EXPECT_TRUE(quarter.mesh.curved_elems.empty());
  EXPECT_EQ(jacobian_ratio_bounds(quarter.mesh), std::vector<double>{1});
}

}  // namespace
}  // namespace quadrille::triangulate
