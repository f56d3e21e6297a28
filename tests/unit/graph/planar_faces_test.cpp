#include "graph/planar_faces.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/error.hpp"

namespace quadrille::graph {
namespace {

std::string message_of(const SeparatrixGraph& graph) {
  try {
    require_four_corners(graph);
  } catch (const ComputeError& error) {
    return error.what();
  }
  return "";
}

TEST(PlanarFaces, OneBlockIsOneCycleOfItsFourSides) {
  const PlanarFaces faces = planar_faces(hand_made::unit_square());
  ASSERT_EQ(faces.cycles.size(), 1u);
  EXPECT_EQ(faces.cycles[0], (std::vector<HalfEdge>{{0}, {1}, {2}, {3}}));
  EXPECT_EQ(faces.quarters[0], (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(faces.num_components, 1);
}

TEST(PlanarFaces, EveryHalfEdgeInsideTheDomainLiesInOneCycle) {
  const SeparatrixGraph graph = hand_made::l_shape();
  std::vector<int> uses(2 * graph.arcs.size(), 0);
  for (const auto& cycle : planar_faces(graph).cycles)
    for (const HalfEdge h : cycle) ++uses[h.index()];
  for (size_t a = 0; a < graph.arcs.size(); ++a) {
    EXPECT_EQ(uses[2 * a], 1);
    EXPECT_EQ(uses[2 * a + 1], graph.arcs[a].is_boundary ? 0 : 1);
  }
}

TEST(PlanarFaces, CyclesAreClosedAndWalkedCounterClockwise) {
  const SeparatrixGraph graph = hand_made::l_shape();
  for (const auto& cycle : planar_faces(graph).cycles) {
    double area = 0;
    for (size_t k = 0; k < cycle.size(); ++k) {
      EXPECT_EQ(end_of(graph.arcs, cycle[k]), start_of(graph.arcs, cycle[(k + 1) % cycle.size()]));
      area += cross(graph.nodes[start_of(graph.arcs, cycle[k])].position,
                    graph.nodes[end_of(graph.arcs, cycle[k])].position);
    }
    EXPECT_NEAR(area / 2, 1, 1e-14);  // three unit squares
  }
}

TEST(PlanarFaces, HalfEdgesAroundABoundaryNodeBeginAndEndOnTheBoundary) {
  const SeparatrixGraph graph = hand_made::l_shape();
  const auto around = half_edges_around_nodes(graph);
  for (const auto& half_edges : around) {
    EXPECT_TRUE(!half_edges.front().is_backwards && graph.arcs[half_edges.front().arc].is_boundary);
    EXPECT_TRUE(half_edges.back().is_backwards && graph.arcs[half_edges.back().arc].is_boundary);
  }
  EXPECT_EQ(around[3].size(), 4u);  // the reflex corner: two sides, two separatrices
}

TEST(Census, CountsTheBlocksOfKnownLayouts) {
  EXPECT_EQ(require_four_corners(hand_made::unit_square()), 1);
  EXPECT_EQ(require_four_corners(hand_made::quarter_annulus()), 1);
  EXPECT_EQ(require_four_corners(hand_made::l_shape()), 3);
  EXPECT_EQ(require_four_corners(hand_made::s_bend()), 1);
  EXPECT_EQ(require_four_corners(hand_made::cut_annulus(4)), 4);
}

TEST(Census, NamesTheFaceThatHasNotFourCorners) {
  SeparatrixGraph graph = hand_made::l_shape();
  graph.arcs.pop_back();  // the reflex corner has lost a line: its face has six corners less one reflex one
  const std::string message = message_of(graph);
  EXPECT_NE(message.find("1 of 2 faces"), std::string::npos) << message;
}

TEST(Census, AddsTheOriginToThePlace) {
  SeparatrixGraph graph = hand_made::unit_square();
  graph.nodes[0].valence = 2;
  graph.face.origin = {100, 200};
  const std::string message = message_of(graph);
  EXPECT_NE(message.find("(100.5, 200.5) has 3"), std::string::npos) << message;
}

TEST(Census, AnUncutAnnulusIsRefused) {
  SeparatrixGraph graph = hand_made::cut_annulus(4);
  std::erase_if(graph.arcs, [](const GraphArc& arc) { return !arc.is_boundary; });
  EXPECT_EQ(planar_faces(graph).num_components, 2);
  EXPECT_EQ(planar_faces(graph).cycles.size(), 2u);
  EXPECT_NE(message_of(graph), "");
}

}  // namespace
}  // namespace quadrille::graph
