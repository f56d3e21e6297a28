#include "mesh/lifted_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../chart_samples.hpp"
#include "spectral/quadrature.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::mesh {
namespace {

/// One element of the order on the patch of the unit sphere whose chart is [0, 1/2]^2.
QuadMesh one_element(const CadFace& face, int order) {
  QuadMesh mesh;
  mesh.face = face;
  mesh.order = order;
  for (const double y : spectral::gll_points(order))
    for (const double x : spectral::gll_points(order)) mesh.nodes.push_back({(1 + x) / 4, (1 + y) / 4});
  for (int k = 0; k < mesh.nodes_per_elem(); ++k) mesh.elem_nodes.push_back(k);
  mesh.elem_block = {0};
  mesh.elem_jacobian_bound = {1}, mesh.elem_scaled_jacobian = {1};
  for (int side = 0; side < 4; ++side) mesh.boundary_edges.push_back({0, side, side});
  return mesh;
}

QuadMesh lifted(QuadMesh mesh) {
  const ChartMap map(mesh.face);
  lift_nodes(map, mesh);
  return mesh;
}

double worst(const QuadMesh& mesh) { return surface_distance(ChartMap(mesh.face), mesh).worst(); }

TEST(LiftNodes, AllNodesAreOnTheSphereAtTheirPlaces) {
  const QuadMesh mesh = lifted(one_element(samples::sphere_face(4, 8), 4));
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    EXPECT_NEAR(norm(mesh.space_nodes[n]), 1, 1e-14);
    EXPECT_LT(distance(mesh.space_nodes[n], samples::on_sphere(mesh.nodes[n])), 1e-7);
  }
}

TEST(LiftNodes, NodesOfTheBoundaryAreOnItsCurvesAndCornersAreTheirEnds) {
  const QuadMesh mesh = lifted(one_element(samples::sphere_face(2, 6), 3));
  const Chart& chart = *mesh.face.chart;
  for (int side = 0; side < 4; ++side) {
    const SpaceCurve& curve = chart.space_curves[side];
    EXPECT_EQ(mesh.space_nodes[side_start(mesh, 0, side)], curve.poles.front());
    const Vec2 a = mesh.face.curves[side].poles.front(), along = mesh.face.curves[side].poles.back() - a;
    for (const int node : side_nodes(mesh, 0, side)) {
      const double t = std::lerp(curve.begin(), curve.end(), dot(mesh.nodes[node] - a, along) / norm2(along));
      EXPECT_LT(distance(surface::point(curve, t), mesh.space_nodes[node]), 1e-14);
    }
  }
}

TEST(LiftNodes, ANodeBesideAJointMovesThere) {
  QuadMesh mesh = one_element(samples::sphere_face(2, 6), 2);
  mesh.nodes[2] = {0.5, 1e-9};  // the joint of curves 0 and 1 is (0.5, 0)
  mesh = lifted(mesh);
  EXPECT_EQ(mesh.nodes[2], (Vec2{0.5, 0}));
  EXPECT_EQ(mesh.space_nodes[2], mesh.face.chart->space_curves[1].poles.front());
  mesh.nodes[2] = {0.5, 1e-6};
  EXPECT_EQ(lifted(mesh).nodes[2], (Vec2{0.5, 1e-6}));
}

/// With equal parameters, though the first curve's nodes were placed elsewhere than the second's.
TEST(LiftNodes, NodesOfPeriodicCurvesAreAtOneParameter) {
  QuadMesh mesh = one_element(samples::sphere_face(2, 6), 2);
  CadFace& face = mesh.face;
  face.periodic_pairs = {{{0, 2}, 0, {0, 0.5}}};
  const int first = side_node(mesh, 0, 0, 1), second = side_node(mesh, 0, 2, 1);
  mesh.nodes[first].x = 0.2;
  mesh = lifted(mesh);
  EXPECT_LT(distance(mesh.space_nodes[first], samples::on_sphere({0.2, 0})), 1e-9);
  EXPECT_LT(distance(mesh.space_nodes[second], samples::on_sphere({0.2, 0.5})), 1e-9);
}

TEST(SurfaceDistance, FallsWithTheOrderAndIsZeroForNodesAlone) {
  const CadFace face = samples::sphere_face(4, 8);
  double before = 1;
  for (const int order : {1, 2, 4, 8}) {
    const double distance = worst(lifted(one_element(face, order)));
    EXPECT_LT(distance, before / 4) << order;
    before = distance;
  }
  EXPECT_LT(before, 1e-7);
}

/// The middle of the bilinear element through the corners of the patch, which are less far from (0, 0, 1).
TEST(SurfaceDistance, OfABilinearElementIsThatOfItsMiddleOrOfAnEdge) {
  const QuadMesh mesh = lifted(one_element(samples::sphere_face(4, 8), 1));
  Vec3 middle;
  for (const Vec3 x : mesh.space_nodes) middle += x / 4;
  const SurfaceDistance found = surface_distance(ChartMap(mesh.face), mesh);
  EXPECT_NEAR(found.worst(), 1 - norm(middle), 1e-9);
  EXPECT_EQ(found.worst_elem, 0);
  EXPECT_EQ(found.position, (Vec2{0.25, 0.25}));
}

/// A node of an edge that slides off its curve, on the sphere.
TEST(SurfaceDistance, EdgesMustFollowTheirCurves) {
  QuadMesh mesh = lifted(one_element(samples::sphere_face(4, 8), 6));
  const int node = side_node(mesh, 0, 0, 3);
  mesh.space_nodes[node] = samples::on_sphere({mesh.nodes[node].x, -1e-3});
  EXPECT_GT(worst(mesh), 1e-4);
}

}  // namespace
}  // namespace quadrille::mesh
