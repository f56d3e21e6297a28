#include "graph/separatrix_lines.hpp"

#include <gtest/gtest.h>

#include "../support/hall.hpp"

namespace quadrille::graph {
namespace {

TEST(SeparatrixLines, AreThoseThatTheGraphWasBuiltFrom) {
  const CandidateLayout layout = hall(0.1);
  const std::vector<SeparatrixLine> lines = lines_of_arcs(layout.graph(), spline_kinds(layout.graph(), layout.lines));
  ASSERT_EQ(lines.size(), layout.lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].arcs, layout.lines[i].arcs);
    EXPECT_EQ(lines[i].origin, layout.lines[i].origin);
    EXPECT_EQ(lines[i].end, layout.lines[i].end);
    EXPECT_EQ(lines[i].kind, layout.lines[i].kind);
  }
}

TEST(SeparatrixLines, ASplineInTwoRunsIsTwoLines) {
  ArcGraph graph;
  graph.splines.resize(1);
  graph.nodes.resize(4);
  graph.arcs = {{0, 1, false, 0, {{0, 0, 1}}}, {3, 2, false, 0, {{0, 3, 2}}}};
  const std::vector<SeparatrixLine> lines = lines_of_arcs(graph, {LineKind::merged});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].origin, 2);  // in the direction of the spline
  EXPECT_EQ(lines[1].end, 3);
}

}  // namespace
}  // namespace quadrille::graph
