#include "couple/continue_lines.hpp"

#include <gtest/gtest.h>

#include "../support/square_t_mesh.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

TEST(ContinueLines, ALineDividesTheFaceOfTheNeighbour) {
  Rectangles two({{{0.3, 0.3}}, {}});
  EXPECT_EQ(continue_lines(two.layouts, CutEnds::included, ContinueTo::first_line), 1);
  EXPECT_EQ(two.layouts.layouts[1].subdivision.num_faces(), 2);
  ASSERT_EQ(two.layouts.layouts[1].lines.size(), 1U);
  EXPECT_EQ(two.layouts.layouts[1].lines[0].kind, LineKind::traced);
  EXPECT_TRUE(two.has_node(1, {1, 0.3}));
  EXPECT_EQ(continue_lines(two.layouts, CutEnds::included, ContinueTo::first_line), 0) << "now a line is there";
}

// The left square has one line from its bottom to its top.
Rectangles with_line_in_the_way() {
  Rectangles two({{}, {{0.3, 0.3}}});
  SeparatrixGraph graph = square_t_mesh::make({{{0.5, 0}, {0.5, 1}, 0, 2}});
  graph.face = two.layouts.layouts[0].graph().face;
  two.layouts.layouts[0] = graph::candidate_layout(std::move(graph));
  return two;
}

TEST(ContinueLines, TheFirstLineEndsItOrTheBoundary) {
  Rectangles stopped = with_line_in_the_way();
  EXPECT_EQ(continue_lines(stopped.layouts, CutEnds::included, ContinueTo::first_line), 1);
  EXPECT_EQ(stopped.layouts.layouts[0].subdivision.num_faces(), 3);
  EXPECT_TRUE(stopped.has_node(0, {0.5, 0.3}));
  Rectangles crossing = with_line_in_the_way();
  EXPECT_EQ(continue_lines(crossing.layouts, CutEnds::included, ContinueTo::boundary), 1);
  EXPECT_EQ(crossing.layouts.layouts[0].subdivision.num_faces(), 4);
}

TEST(RemoveNeedlessCuts, RemovesCutsAndTheirNodesAlone) {
  Rectangles two({{{0.3, 0.3, LineKind::cut}, {0.6, 0.6}}, {}});
  EXPECT_EQ(remove_needless_cuts(two.layouts), 1);
  EXPECT_EQ(two.layouts.layouts[0].subdivision.num_faces(), 2);
  EXPECT_EQ(two.graph(0).nodes.size(), 6U);
  ASSERT_EQ(two.layouts.layouts[0].lines.size(), 1U);
  EXPECT_EQ(two.layouts.layouts[0].lines[0].kind, LineKind::traced);
}

}  // namespace
}  // namespace quadrille::couple
