#include "triangulate/curve_elements.hpp"

#include <gtest/gtest.h>

#include "faces.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

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
