#include "layout/midpoint_layout.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../samples.hpp"
#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "check/check.hpp"
#include "graph/candidate_layout.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::layout {
namespace {

double bound_of(const SeparatrixGraph& graph, const std::array<HalfEdge, 4>& sides) {
  return jacobian_bound(curve::CurveTable(graph.face, graph.splines), graph, sides);
}

/// A face that is one triangle, counter-clockwise.
TriMesh triangle(const std::array<Vec2, 3>& p) {
  TriMesh mesh;
  for (int k = 0; k < 3; ++k) {
    mesh.face.curves.push_back(samples::line(p[k], p[(k + 1) % 3]));
    mesh.face.joints.push_back({p[k], 0, 0, 1, true});
    mesh.boundary_edges.push_back({0, k, k, 0, 1});
  }
  mesh.face.loop_offsets = {0, 3};
  mesh.vertices = {p.begin(), p.end()};
  mesh.elem2vertices = {{0, 1, 2}};
  return mesh;
}

TEST(DivideTriangles, FourTrianglesOfASquareMakeTwelveBlocks) {
  const DividedTriangles divided = divide_triangles(samples::tri_mesh());
  const SeparatrixGraph& graph = divided.graph;
  ASSERT_EQ(graph.nodes.size(), 5u + 8 + 4);
  EXPECT_EQ(graph.arcs.size(), 2u * 8 + 3 * 4);
  EXPECT_EQ(divided.blocks.size(), 4u);
  EXPECT_EQ(index_sum_of(graph), 4);
  for (int v = 0; v < 4; ++v) {
    EXPECT_EQ(graph.nodes[v].kind, NodeKind::corner);
    EXPECT_EQ(graph.nodes[v].valence, 2);
    EXPECT_EQ(graph.nodes[v].curve, v);
  }
  EXPECT_EQ(graph.nodes[4].kind, NodeKind::crossing);  // four triangles around it
  EXPECT_EQ(graph.nodes.back().valence, 3);
}

TEST(DivideTriangles, SidesOfBlocksJoinCounterClockwise) {
  const DividedTriangles divided = divide_triangles(samples::tri_mesh());
  const auto& arcs = divided.graph.arcs;
  for (std::size_t elem = 0; elem < divided.blocks.size(); ++elem)
    for (int k = 0; k < 3; ++k) {
      const std::array<HalfEdge, 4>& sides = divided.blocks[elem][k];
      EXPECT_EQ(start_of(arcs, sides[0]), samples::tri_mesh().elem2vertices[elem][k]);
      for (int i = 0; i < 4; ++i) EXPECT_EQ(end_of(arcs, sides[i]), start_of(arcs, sides[(i + 1) % 4]));
      EXPECT_GT(bound_of(divided.graph, sides), 0);
    }
}

// The coefficients are 1/4, 1/6, 1/6 and 1/12 of the triangle's determinant.
TEST(DivideTriangles, TheLeastJacobianOfAStraightTriangleIsATwelfth) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 200; ++i) {
    std::array<Vec2, 3> p;
    for (Vec2& x : p) x = {coordinate(random), coordinate(random)};
    double determinant = cross(p[1] - p[0], p[2] - p[0]);
    if (determinant < 0) std::swap(p[1], p[2]), determinant = -determinant;
    const DividedTriangles divided = divide_triangles(triangle(p));
    for (const auto& sides : divided.blocks[0])
      EXPECT_NEAR(bound_of(divided.graph, sides), determinant / 12, 1e-9 * determinant + 1e-11);
  }
}

TEST(DivideTriangles, ABulgingEdgeMovesTheCentreByFourNinths) {
  TriMesh mesh = triangle({{{0, 0}, {2, 0}, {0, 2}}});
  mesh.face.curves[0] = {2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, -0.6}, {2, 0}}, {1, 1, 1}};  // bulges by 0.3
  const SeparatrixGraph graph = divide_triangles(mesh).graph;
  EXPECT_NEAR(graph.nodes.back().position.x, 2.0 / 3, 1e-12);
  EXPECT_NEAR(graph.nodes.back().position.y, 2.0 / 3 - 0.3 * 4 / 9, 1e-12);
}

/// A triangle whose lower side is a parabola that is higher by `rise` in its middle.
TriMesh triangle_above_parabola(double rise) {
  const std::array<Vec2, 3> p{{{0, 0}, {2, 0}, {1, 1}}};
  TriMesh mesh;
  for (int k = 0; k < 3; ++k) {
    mesh.face.curves.push_back(samples::line(p[k], p[(k + 1) % 3]));
    mesh.face.joints.push_back({p[k], 0, 0, 1, true});
    mesh.boundary_edges.push_back({0, k, k, 0, 1});
  }
  mesh.face.curves[0] = {2, {0, 0, 0, 1, 1, 1}, {p[0], {1, 2 * rise}, p[1]}, {1, 1, 1}};
  mesh.face.loop_offsets = {0, 3};
  mesh.vertices = {p.begin(), p.end()};
  mesh.elem2vertices = {{0, 1, 2}};
  mesh.curved_elems = {0};
  return mesh;
}

std::vector<int> doubtful(const TriMesh& mesh) { return doubtful_triangles(mesh, divide_triangles(mesh)); }

TEST(DoubtfulTriangles, ATriangleBesideAFlatCurveIsNot) {
  EXPECT_TRUE(doubtful(triangle_above_parabola(0.1)).empty());
  EXPECT_TRUE(doubtful(triangle_above_parabola(-0.2)).empty());
}

// The tangents of the parabola at its ends rise by 4 times its middle for each unit of length: steeper than the sides.
TEST(DoubtfulTriangles, ATriangleWhoseCurveLeavesItAtAVertexIs) {
  EXPECT_EQ(doubtful(triangle_above_parabola(0.6)), std::vector<int>{0});
}

TEST(DoubtfulTriangles, OnlyTrianglesWithACurvedEdgeAreMeasured) {
  TriMesh mesh = triangle_above_parabola(0.6);
  mesh.curved_elems.clear();
  EXPECT_TRUE(doubtful(mesh).empty());
}

TriMesh triangulated(const CadFace& face) {
  Report report;
  return triangulate::triangulate(face, {}, report);
}

struct Outcome {
  SeparatrixGraph graph;
  long long triangles = 0;
  std::string origin;
};

Outcome divided(const TriMesh& mesh) {
  Report report;
  Outcome outcome{midpoint_graph(mesh, triangulate::coarse_triangles, report), 0, ""};
  for (const auto& [key, value] : report.entries()) {
    if (key == "midpoint.triangles") outcome.triangles = std::get<long long>(value);
    if (key == "midpoint.origin") outcome.origin = std::get<std::string>(value);
  }
  return outcome;
}

TEST(MidpointGraph, KeepsTheRulesOfItsFormat) {
  for (const CadFace& face : {testing_faces::square(), testing_faces::half_disc(), testing_faces::annulus(),
                              testing_faces::l_shape(), testing_faces::stadium()}) {
    const SeparatrixGraph graph = divided(triangulated(face)).graph;
    const std::vector<check::Violation> broken = check::check_stage(graph, check::CheckDepth::full);
    EXPECT_TRUE(broken.empty()) << broken.front().text;
    EXPECT_EQ(index_sum_of(graph), 4 * face.euler_characteristic());
  }
}

TEST(MidpointGraph, TrianglesAreMadeAnewAndFew) {
  const TriMesh mesh = triangulated(testing_faces::l_shape());  // has a fan at the re-entrant corner
  const Outcome outcome = divided(mesh);
  EXPECT_EQ(outcome.origin, "coarse");
  EXPECT_LE(outcome.triangles, 8);
  EXPECT_LT(outcome.triangles, mesh.num_elems() / 2);
}

// A corner whose two sides nearly coincide outside the face needs a ring around it; without one there is no end.
TEST(MidpointGraph, ANarrowNotchHasCoarseTrianglesToo) {
  const CadFace face =
      testing_faces::make_face({testing_faces::polygon({{0, 0}, {4, 0}, {4, 1.9}, {2, 2}, {4, 2.1}, {4, 4}, {0, 4}})});
  const Outcome outcome = divided(triangulated(face));
  EXPECT_EQ(outcome.origin, "coarse");
  EXPECT_LE(outcome.triangles, 100);
}

TEST(MidpointGraph, WithoutCoarseTrianglesThoseOfTheMeshAreDivided) {
  TriMesh mesh = triangulated(testing_faces::square());
  // The mesh is that of a square; the face has a hole as well, which crosses the outline.
  const CadFace crossed = testing_faces::make_face(
      {testing_faces::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), testing_faces::hole({1, 0.5}, 0.2)});
  mesh.face = crossed;
  const Outcome outcome = divided(mesh);
  EXPECT_EQ(outcome.origin, "field");
  EXPECT_EQ(outcome.triangles, mesh.num_elems());
}

TEST(MidpointGraph, WithoutAMesherThereIsNone) {
  Report report;
  EXPECT_THROW(midpoint_graph(triangulated(testing_faces::square()), {}, report), ComputeError);
}

TriMesh annulus() {
  Report report;
  return triangulate::triangulate(testing_faces::annulus(), {}, report);
}

TEST(MidpointLayout, EveryFaceHasFourCorners) {
  Report report;
  const graph::CandidateLayout layout = midpoint_layout(annulus(), triangulate::coarse_triangles, report);
  EXPECT_TRUE(graph::faces_without_four_corners(layout.subdivision).empty());
  EXPECT_EQ(layout.subdivision.num_faces() % 3, 0);
}

TEST(MidpointLayout, WithoutAFieldOnlyMidpointAndAutoArePossible) {
  for (const LayoutChoice choice : {LayoutChoice::traced, LayoutChoice::quantized, LayoutChoice::t_mesh})
    EXPECT_THROW(reason_without_field(choice), UsageError);
  EXPECT_EQ(reason_without_field(LayoutChoice::midpoint), "");
  EXPECT_NE(reason_without_field(LayoutChoice::automatic), "");
}

TEST(MidpointLayout, AReasonIsAWarning) {
  Report report;
  graph::CandidateLayout layout = midpoint_layout(annulus(), triangulate::coarse_triangles, report);
  certify_midpoint(layout, "", report);
  EXPECT_TRUE(report.warnings().empty());
  EXPECT_EQ(layout.certificate.reason, "");
  certify_midpoint(layout, "the lines spiral", report);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings().front().code, "W-SEP-002");
  EXPECT_EQ(layout.certificate.reason, "the lines spiral");
}

TEST(MidpointLayout, TheCertificateCountsBlocksAndIndices) {
  Report report;
  graph::CandidateLayout layout = midpoint_layout(annulus(), triangulate::coarse_triangles, report);
  certify_midpoint(layout, "", report);
  EXPECT_EQ(layout.certificate.method, LayoutMethod::midpoint);
  EXPECT_EQ(layout.certificate.index_sum, 0);
  ASSERT_EQ(layout.certificate.face_valence_histogram.size(), 1u);
  EXPECT_EQ(layout.certificate.face_valence_histogram.front().corners, 4);
  EXPECT_EQ(layout.certificate.largest_deviation_degrees, 0);
}

}  // namespace
}  // namespace quadrille::layout
