#include "couple/continue_lines.hpp"

#include <gtest/gtest.h>

#include "../support/square_t_mesh.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

bool always(const graph::Subdivision&, const BoundaryPoint&) { return true; }

double height(const CadFace& face, const BoundaryPoint& point) { return point.position(face).y; }

TEST(Continuations, ALineThatEndsAloneIsTracedThroughTheNeighbour) {
  const Rectangles two({{{0.3, 0.3}}, {}});
  const std::vector<Continuation> found = continuations(two.layouts, CutEnds::included, always);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].region, 1);
  EXPECT_EQ(found[0].start.curve, 3) << "of the region: its left side";
  ASSERT_TRUE(found[0].line && found[0].line->ends_on_boundary);
  EXPECT_EQ(found[0].line->end.curve, 1);
  EXPECT_NEAR(height(two.graph(1).face, found[0].line->end), 0.3, 1e-7);
  EXPECT_NEAR(found[0].line->spline.end(), 1, 1e-7) << "by its length";
}

TEST(Continuations, LinesThatMeetNeedNone) {
  const Rectangles two({{{0.3, 0.3}}, {{0.3, 0.3}}});
  EXPECT_TRUE(continuations(two.layouts, CutEnds::included, always).empty());
}

TEST(Continuations, ThoseThatCannotBeInsertedAreLeftOut) {
  const Rectangles two({{{0.3, 0.3}}, {}});
  const auto never = [](const graph::Subdivision&, const BoundaryPoint&) { return false; };
  EXPECT_TRUE(continuations(two.layouts, CutEnds::included, never).empty());
}

TEST(Continuations, OppositeLinesThatAreNearMerge) {
  const Rectangles three({{{0.3, 0.3}}, {}, {{0.36, 0.36}}});
  const std::vector<Continuation> found = continuations(three.layouts, CutEnds::included, always);
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].line);
  EXPECT_EQ(found[0].line->end, found[1].start);
  EXPECT_FALSE(found[1].line);
}

TEST(Continuations, OppositeLinesThatAreFarStayTwo) {
  const Rectangles three({{{0.3, 0.3}}, {}, {{0.5, 0.5}}});
  const std::vector<Continuation> found = continuations(three.layouts, CutEnds::included, always);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].line && found[1].line);
}

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
