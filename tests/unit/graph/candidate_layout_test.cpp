#include "graph/candidate_layout.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "../support/hall.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

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

std::string refusal(const SeparatrixGraph& graph) {
  return message_of<ComputeError>([&] { require_four_corners(Subdivision(graph)); });
}

TEST(FaceCorners, TheBlocksOfKnownLayoutsAreCounted) {
  EXPECT_EQ(require_four_corners(Subdivision(hand_made::unit_square())), 1);
  EXPECT_EQ(require_four_corners(Subdivision(hand_made::quarter_annulus())), 1);
  EXPECT_EQ(require_four_corners(Subdivision(hand_made::l_shape())), 3);
  EXPECT_EQ(require_four_corners(Subdivision(hand_made::s_bend())), 1);
  EXPECT_EQ(require_four_corners(Subdivision(hand_made::cut_annulus(4))), 4);
}

TEST(FaceCorners, AFaceThatHasNotFourIsNamed) {
  SeparatrixGraph graph = hand_made::l_shape();
  graph.arcs.pop_back();  // the reflex corner has lost a line: its face has six corners less one reflex one
  const std::string message = refusal(graph);
  EXPECT_NE(message.find("1 of 2 faces"), std::string::npos) << message;
}

TEST(FaceCorners, TheOriginIsAddedToThePlace) {
  SeparatrixGraph graph = hand_made::unit_square();
  graph.nodes[0].valence = 2;
  graph.face.origin = {100, 200};
  const std::string message = refusal(graph);
  EXPECT_NE(message.find("(100.5, 200.5) has 3"), std::string::npos) << message;
}

TEST(FaceCorners, AnUncutAnnulusIsRefused) {
  SeparatrixGraph graph = hand_made::cut_annulus(4);
  std::erase_if(graph.arcs, [](const GraphArc& arc) { return !arc.is_boundary; });
  const Subdivision subdivision(graph);
  EXPECT_EQ(subdivision.num_components(), 2);
  EXPECT_EQ(subdivision.num_faces(), 2);
  EXPECT_NE(refusal(graph), "");
}

TEST(FaceCorners, TheHistogramCountsFacesByCorners) {
  SeparatrixGraph graph = hand_made::l_shape();
  graph.arcs.pop_back();
  const std::vector<FaceCount> histogram = face_valence_histogram(Subdivision(graph));
  int faces = 0;
  for (const FaceCount& count : histogram) faces += count.faces;
  EXPECT_EQ(faces, 2);
  EXPECT_EQ(face_valence_histogram(Subdivision(hand_made::l_shape())).size(), 1u);
}

TEST(FaceCorners, CurvesOutOfOrderAreSeen) {
  Subdivision subdivision(hand_made::l_shape());
  for (int n = 0; n < subdivision.node_bound(); ++n) EXPECT_TRUE(is_drawn_in_order(subdivision, n));
  EXPECT_NO_THROW(require_drawn_in_order(subdivision));
  // The two lines at the reflex corner change places.
  const std::vector<HalfEdge> around = subdivision.around(3);
  const auto pieces = [&](HalfEdge h) { return subdivision.graph().arcs[h.arc].pieces; };
  const auto first = pieces(around[1]), second = pieces(around[2]);
  subdivision.set_pieces(around[1].arc, second);
  subdivision.set_pieces(around[2].arc, first);
  EXPECT_FALSE(is_drawn_in_order(subdivision, 3));
  EXPECT_THROW(require_drawn_in_order(subdivision), ComputeError);
}

}  // namespace
}  // namespace quadrille::graph
