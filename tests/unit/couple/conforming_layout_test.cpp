#include "couple/conforming_layout.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "base/error.hpp"
#include "couple/join_layouts.hpp"
#include "graph/face_corners.hpp"
#include "model/periodic.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

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
