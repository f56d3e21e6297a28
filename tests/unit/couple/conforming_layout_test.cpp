#include "couple/conforming_layout.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "couple/join_layouts.hpp"
#include "graph/candidate_layout.hpp"
#include "model/periodic.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

using namespace testing_faces;

/// A square with a slit from the middle of its right side to the left and then up, or on to the left.
CadFace bent_slit(Vec2 end) {
  CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 2}, {2, 2}, end, {2, 2}, {4, 2}, {4, 4}, {0, 4}})});
  pair_sides(face, 2, 5);
  pair_sides(face, 3, 4);
  return face;
}

TEST(InterfaceCorner, IsWhereASlitTurns) {
  const auto found = sharpest_interface_corner(bent_slit({2, 3}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->joint, 3);
  EXPECT_NEAR(degrees(found->turn), 90, 1e-9);
}

TEST(InterfaceCorner, IsNoneAtEndsAndInSmoothCurves) {
  EXPECT_FALSE(sharpest_interface_corner(bent_slit({1, 2})));
  EXPECT_FALSE(sharpest_interface_corner(bent_slit({1, 2.5})));
  EXPECT_FALSE(sharpest_interface_corner(slit_square()));
  EXPECT_FALSE(sharpest_interface_corner(square())) << "its corners belong to no embedded curve";
}

TEST(SnapPeriodicNodes, MovesNodesOntoNearImages) {
  PeriodicSquare square({{0.3, 0.3 + 5e-9}});
  SeparatrixGraph graph = graph::separatrix_graph(std::move(square.layouts.layouts.front()));
  snap_periodic_nodes(graph);
  EXPECT_NEAR(graph.nodes[5].t, 0.3, 1e-15) << "the end on the second side";
  EXPECT_EQ(graph.splines[0].poles.back(), graph.nodes[5].position);
  EXPECT_EQ(periodic_arcs(graph).size(), 2U);
}

TEST(SnapPeriodicNodes, LeavesOthersAlone) {
  PeriodicSquare square({{0.3, 0.3001}});
  SeparatrixGraph graph = graph::separatrix_graph(std::move(square.layouts.layouts.front()));
  snap_periodic_nodes(graph);
  EXPECT_EQ(graph.nodes[5].t, 0.3001);
}

TEST(DividePeriodicSides, EachSideHasANodeWhereTheOtherOneHas) {
  PeriodicSquare square({{0.3, 0.5}});
  EXPECT_EQ(divide_periodic_sides(square.layouts.layouts.front()), 2);
  EXPECT_TRUE(square.has_node(0, {0, 0.5}));
  EXPECT_TRUE(square.has_node(0, {1, 0.3}));
  EXPECT_EQ(periodic_arcs(square.graph(0)).size(), 3U);
  EXPECT_EQ(divide_periodic_sides(square.layouts.layouts.front()), 0) << "now they are images of each other";
}

graph::CandidateLayout conforming(const Rectangles& squares, Report& report) {
  return conforming_layout(squares.layouts, graph::candidate_layout(join_layouts(squares.layouts)), report);
}

long long reported(const Report& report, const std::string& key) {
  for (const auto& [name, value] : report.entries())
    if (name == key) return std::get<long long>(value);
  return -1;
}

TEST(ConformingLayout, ALineContinuesFromItsTJunctionToTheBoundary) {
  Report report;
  const graph::CandidateLayout layout = conforming(Rectangles({{{0.5, 0.5}}, {}}), report);
  EXPECT_TRUE(layout.t_junctions.empty());
  EXPECT_EQ(graph::require_four_corners(layout.subdivision), 4);
  EXPECT_EQ(reported(report, "couple.periodic_lines_met"), -1) << "there are no periodic sides";
}

TEST(ConformingLayout, LinesOnBothSidesBecomeOneOrPassEachOther) {
  Report report;
  const graph::CandidateLayout layout = conforming(Rectangles({{{0.5, 0.5}}, {{0.5, 0.5}}}), report);
  EXPECT_EQ(graph::require_four_corners(layout.subdivision), 4);
}

TEST(ConformingLayout, NearEndsOnPeriodicSidesMatch) {
  Report report;
  const graph::CandidateLayout layout = conforming(PeriodicSquare({{0.5, 0.56}}), report);
  EXPECT_EQ(reported(report, "couple.periodic_lines_met"), 1);
  EXPECT_EQ(reported(report, "couple.periodic_t_junctions"), 0);
  EXPECT_EQ(periodic_arcs(layout.graph()).size(), 2U);
}

// The line leaves the right side above where it left the left side, and so on for ever: both ends must be one.
TEST(ConformingLayout, EndsThatNoIntegerGridSeparatesAreForcedToMatch) {
  Report report;
  const graph::CandidateLayout layout = conforming(PeriodicSquare({{0.2, 0.8}}), report);
  EXPECT_EQ(reported(report, "couple.periodic_lines_met"), 1);
  EXPECT_EQ(graph::require_four_corners(layout.subdivision), 2);
  EXPECT_EQ(periodic_arcs(layout.graph()).size(), 2U);
}

// Ends that cannot move, as at irregular nodes.
TEST(ConformingLayout, WithoutIntegerLengthsTheMessageNamesTheRemedy) {
  PeriodicSquare square({{0.2, 0.8}});
  SeparatrixGraph graph = graph::separatrix_graph(std::move(square.layouts.layouts.front()));
  for (const int node : {4, 5}) graph.nodes[node].kind = NodeKind::irregular;
  square.layouts.layouts.front() = graph::candidate_layout(std::move(graph));
  Report report;
  try {
    conforming(square, report);
    FAIL() << "no integer grid exists";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("cad2tri --periodic"), std::string::npos);
  }
}

}  // namespace
}  // namespace quadrille::couple
