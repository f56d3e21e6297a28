#include "couple/couple_layouts.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>

#include "../regions/faces_of_regions.hpp"
#include "adapt/adapt_loop.hpp"
#include "base/angle.hpp"
#include "choice/choose_nodes.hpp"
#include "curve/project.hpp"
#include "field/error_estimate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "galerkin/solve_phase.hpp"
#include "graph/candidate_layout.hpp"
#include "graph/subdivision.hpp"
#include "layout/compute_layout.hpp"
#include "model/interfaces.hpp"
#include "regions/split.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::couple {
namespace {

using namespace testing_faces;

Field guiding_field(const CadFace& face, CriticalPoints& points) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(face, {}, report);
  Field field = galerkin::solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 8), {}, report);
  field = adapt::adapt_loop(field, {}, report);
  if (field.elem_error.empty()) field.elem_error = field::error_estimate(field);
  points = choice::choose_nodes(field, {}, 1, report);
  if (points.form == NodeForm::harmonic) return field;
  galerkin::PhaseSolver solver(mesh, field.elem_order, 1);
  return solver.solve(phase_nodes_of(points), points.hole_winding_offsets, report);
}

/// Layouts of the regions, as separatrix computes them; the fields must outlive them.
struct Regions {
  explicit Regions(const CadFace& whole) {
    layouts.face = whole;
    const std::vector<CadFace> faces = regions::split(whole);
    for (int r = 0; r < whole.num_regions(); ++r) {
      CriticalPoints points;
      fields.push_back(std::make_unique<Field>(guiding_field(faces[r], points)));
      evaluators.push_back(std::make_unique<field::FieldEvaluator>(*fields.back(), field::FarTerms::expanded));
      Report report;
      layouts.layouts.push_back(
          graph::candidate_layout(layout::compute_layout(*evaluators.back(), points, {}, report)));
      layouts.fields.push_back(evaluators.back().get());
      layouts.first_curves.push_back(regions::curves_of(whole, r).begin);
    }
  }

  std::vector<std::unique_ptr<Field>> fields;
  std::vector<std::unique_ptr<field::FieldEvaluator>> evaluators;
  RegionLayouts layouts;
};

SeparatrixGraph coupled(const CadFace& face) {
  Regions regions(face);
  Report report;
  return couple_layouts(std::move(regions.layouts), {}, report);
}

long long value_of(const Report& report, const std::string& key) {
  for (const auto& [name, value] : report.entries())
    if (name == key) return std::get<long long>(value);
  ADD_FAILURE() << key << " is not reported";
  return -1;
}

int num_faces(const SeparatrixGraph& graph) { return graph::Subdivision(graph).num_faces(); }

// Every interface is in the graph once, on the curve of its lower side; every curve of the boundary too.
void expect_covered_once(const SeparatrixGraph& graph) {
  const CadFace& face = graph.face;
  std::vector<double> covered(face.num_curves(), 0);
  for (const GraphArc& arc : graph.arcs)
    for (const ArcPiece& piece : arc.pieces)
      if (piece.curve < face.num_curves()) {
        covered[piece.curve] += piece.t1 - piece.t0;
        EXPECT_EQ(arc.is_boundary, !face.is_interface(piece.curve));
      }
  for (int c = 0; c < face.num_curves(); ++c) {
    const bool is_there = !face.is_interface(c) || c < face.partners[c];
    EXPECT_NEAR(covered[c], is_there ? face.curves[c].end() - face.curves[c].begin() : 0, 1e-12) << "curve " << c;
  }
}

// `chi`: Euler characteristic of the whole.
void expect_layout(const SeparatrixGraph& graph, int chi) {
  EXPECT_EQ(index_sum_of(graph), 4 * chi);
  EXPECT_TRUE(graph.t_junctions.empty());
  expect_covered_once(graph);
}

TEST(CoupleLayouts, two_squares_are_two_blocks) {
  const SeparatrixGraph graph = coupled(face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})}));
  EXPECT_EQ(num_faces(graph), 2);
  EXPECT_EQ(graph.nodes.size(), 6U);
  expect_layout(graph, 1);
}

TEST(CoupleLayouts, a_line_goes_on_beyond_a_t_joint) {
  // The lower rectangle has two neighbours on one straight side, which its own file divides there.
  CadFace lower = make_face({polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}})});
  const SeparatrixGraph graph = coupled(face_of_regions({lower, rectangle({0, 1}, {1, 2}), rectangle({1, 1}, {2, 2})}));
  EXPECT_EQ(num_faces(graph), 4);
  expect_layout(graph, 1);
}

TEST(CoupleLayouts, a_step_gets_the_line_that_the_larger_region_has_not) {
  CadFace lower = make_face({polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}})});
  const SeparatrixGraph graph = coupled(face_of_regions({lower, rectangle({0, 1}, {1, 2})}));
  EXPECT_EQ(num_faces(graph), 3);
  expect_layout(graph, 1);
}

TEST(CoupleLayouts, a_disc_in_a_square_is_turned_to_its_lines) {
  Regions regions(disc_in_square());
  Report report;
  const SeparatrixGraph graph = couple_layouts(std::move(regions.layouts), {}, report);
  expect_layout(graph, 1);
  // Symmetric: with each node its image under the quarter turn and the reflection is one.
  for (const GraphNode& node : graph.nodes)
    for (const Vec2 image : {left_of(node.position), Vec2{node.position.y, node.position.x}}) {
      double least = 1;
      for (const GraphNode& other : graph.nodes) least = std::min(least, distance(other.position, image));
      EXPECT_LT(least, 1e-6) << node.position.x << " " << node.position.y;
    }
  EXPECT_LE(num_faces(graph), 17);
}

TEST(CoupleLayouts, nested_rings_are_turned_to_each_other) {
  const SeparatrixGraph graph =
      coupled(face_of_regions({make_face({circle({0, 0}, 3), hole({0, 0}, 2)}),
                               make_face({circle({0, 0}, 2), hole({0, 0}, 1)}), make_face({circle({0, 0}, 1)})}));
  expect_layout(graph, 1);
  EXPECT_LE(num_faces(graph), 21);
}

TEST(CoupleLayouts, every_pair_of_near_lines_meets) {
  Regions regions(face_of_regions(
      {make_face({polygon({{-3, -2}, {3, -2}, {3, 2}, {-3, 2}}), hole({0, 0}, 1)}), make_face({circle({0, 0}, 1)})}));
  Report report;
  const SeparatrixGraph graph = couple_layouts(std::move(regions.layouts), {}, report);
  expect_layout(graph, 1);
  EXPECT_EQ(value_of(report, "couple.lines_met"), 4) << "also those beside the seam of the circle";
  EXPECT_EQ(value_of(report, "couple.t_junctions"), 0);
}

TEST(CoupleLayouts, lines_go_on_through_a_ring_in_place_of_its_cuts) {
  Regions regions(face_of_regions({make_face({polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}), hole({0, 0}, 2)}),
                                   make_face({circle({0, 0}, 2), hole({0, 0}, 1)})}));
  Report report;
  const SeparatrixGraph graph = couple_layouts(std::move(regions.layouts), {}, report);
  expect_layout(graph, 0);
  EXPECT_EQ(value_of(report, "couple.t_junctions"), 0);
  EXPECT_GE(value_of(report, "couple.lines_continued"), 4);
  for (const SeparatrixLine& line : graph.lines) EXPECT_NE(line.kind, LineKind::cut);
  for (const GraphNode& node : graph.nodes) EXPECT_NE(node.kind, NodeKind::cut);
}

TEST(CoupleLayouts, four_squares_meet_in_a_junction) {
  const SeparatrixGraph graph = coupled(face_of_regions(
      {rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1}), rectangle({0, 1}, {1, 2}), rectangle({1, 1}, {2, 2})}));
  EXPECT_EQ(num_faces(graph), 4);
  expect_layout(graph, 1);
  int junctions = 0;
  for (const GraphNode& node : graph.nodes) junctions += node.kind == NodeKind::junction && node.valence == 4;
  EXPECT_EQ(junctions, 1);
}

TEST(CoupleLayouts, a_slit_consists_of_block_sides) {
  const SeparatrixGraph graph = coupled(slit_square());
  expect_layout(graph, 1);
  int slit_arcs = 0;
  for (const GraphArc& arc : graph.arcs) slit_arcs += !arc.is_boundary && arc.pieces.front().curve < 6;
  EXPECT_GE(slit_arcs, 1);
}

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
