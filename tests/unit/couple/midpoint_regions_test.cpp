#include "couple/midpoint_regions.hpp"

#include <gtest/gtest.h>

#include "../regions/faces_of_regions.hpp"
#include "graph/face_corners.hpp"
#include "graph/subdivision.hpp"
#include "model/interfaces.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::couple {
namespace {

using namespace testing_faces;

/// A mesh of which only the face is used.
TriMesh without_triangles(const CadFace& face) {
  TriMesh mesh;
  mesh.face = face;
  return mesh;
}

SeparatrixGraph division(const CadFace& face) {
  Report report;
  return midpoint_regions(face, without_triangles(face), triangulate::coarse_triangles, "", report);
}

int num_interface_arcs(const SeparatrixGraph& graph) {
  int count = 0;
  for (const GraphArc& arc : graph.arcs) count += is_on_interface(graph, arc) ? 1 : 0;
  return count;
}

// `chi`: Euler characteristic of the whole.
void expect_conforming(const SeparatrixGraph& graph, int chi) {
  EXPECT_TRUE(graph.t_junctions.empty());
  EXPECT_EQ(index_sum_of(graph), 4 * chi);
  EXPECT_TRUE(graph::faces_without_four_corners(graph::Subdivision(graph)).empty());
  EXPECT_EQ(graph::Subdivision(graph).num_components(), 1);
}

TEST(MidpointRegions, TwoSquaresShareTheNodesOfTheirSide) {
  const SeparatrixGraph graph = division(face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})}));
  expect_conforming(graph, 1);
  EXPECT_GE(num_interface_arcs(graph), 2);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::midpoint);
}

TEST(MidpointRegions, AJunctionInsideHasTheValenceOfAllItsSectors) {
  const CadFace face = face_of_regions(
      {rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1}), rectangle({0, 1}, {1, 2}), rectangle({1, 1}, {2, 2})});
  const SeparatrixGraph graph = division(face);
  expect_conforming(graph, 1);
  int num_junctions = 0;
  for (const GraphNode& node : graph.nodes) num_junctions += node.kind == NodeKind::junction ? 1 : 0;
  EXPECT_EQ(num_junctions, 1);
}

TEST(MidpointRegions, ADiscInAHoleIsInsideTheWhole) { expect_conforming(division(disc_in_square()), 1); }

TEST(MidpointRegions, ASlitIsClosed) {
  const SeparatrixGraph graph = division(slit_square());
  expect_conforming(graph, 1);
  EXPECT_GE(num_interface_arcs(graph), 2);
}

TEST(MidpointRegions, AnOpenInterfaceIsTwoBoundaries) {
  const CadFace face = face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})});
  CadFace open = face;
  open.partners.assign(face.num_curves(), -1);
  Report report;
  const SeparatrixGraph graph =
      midpoint_regions(open, without_triangles(face), triangulate::coarse_triangles, "", report);
  EXPECT_EQ(num_interface_arcs(graph), 0);
  EXPECT_EQ(index_sum_of(graph), 8);
}

TEST(MidpointRegions, AReasonIsAWarning) {
  const CadFace face = face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})});
  Report report;
  EXPECT_EQ(midpoint_regions(face, without_triangles(face), triangulate::coarse_triangles, "a strip winds", report)
                .certificate.reason,
            "a strip winds");
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings().front().code, "W-SEP-002");
}

}  // namespace
}  // namespace quadrille::couple
