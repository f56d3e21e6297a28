#include "graph/subdivision.hpp"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

#include "../hand_made.hpp"
#include "../support/grid_layout.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "graph/arc_pieces.hpp"

namespace quadrille::graph {
namespace {

// Straight arcs from the origin to points at these angles (degrees), each on a spline of its own.
ArcGraph star(const std::vector<double>& angles, int valence) {
  SeparatrixGraph g;
  hand_made::add_node(g, {0, 0}, NodeKind::crossing, valence);
  for (const double angle : angles) {
    const int end = hand_made::add_node(g, unit(radians(angle)), NodeKind::crossing, 4);
    hand_made::add_cut(g, 0, end);
  }
  return g;
}

TEST(NodeRotation, HalfEdgesAreSortedByTheirAngles) {
  const ArcGraph graph = star({100, 10, -170, 190 + 80}, 4);
  const std::vector<HalfEdge> around = half_edges_around_nodes(graph)[0];
  ASSERT_EQ(around.size(), 4u);
  for (std::size_t k = 0; k + 1 < around.size(); ++k) {
    const double turn = wrap_two_pi(start_angle(graph, around[k + 1]) - start_angle(graph, around[k]));
    EXPECT_GT(turn, 0);
    EXPECT_LT(turn, pi);
  }
}

TEST(NodeRotation, AHalfEdgeStartsInTheDirectionInWhichItIsFollowed) {
  const ArcGraph graph = star({30}, 1);
  EXPECT_NEAR(start_angle(graph, {0}), radians(30), 1e-12);
  EXPECT_NEAR(wrap_two_pi(start_angle(graph, {0, true})), radians(210), 1e-12);
}

TEST(NodeRotation, WithAllLinesEverySectorIsOneQuarter) {
  const ArcGraph graph = star({0, 20, 40}, 3);
  EXPECT_EQ(sector_quarters(graph, 0, half_edges_around_nodes(graph)[0]), (std::vector<int>{1, 1, 1}));
}

TEST(NodeRotation, ElseTheAnglesDivideTheValence) {
  const ArcGraph graph = star({0, 90}, 4);
  const std::vector<HalfEdge> around = half_edges_around_nodes(graph)[0];
  const std::vector<int> quarters = sector_quarters(graph, 0, around);
  ASSERT_EQ(quarters.size(), 2u);
  EXPECT_EQ(quarters[around[0] == HalfEdge{0} ? 0 : 1], 1);
  EXPECT_EQ(quarters[0] + quarters[1], 4);
}

TEST(NodeRotation, AStraightLineIsHalfATurnAtAnyAngleOfTheLineThatEndsOnIt) {
  SeparatrixGraph g;
  hand_made::add_node(g, {0, 0}, NodeKind::crossing, 4);
  const int left = hand_made::add_node(g, {-1, 0}, NodeKind::crossing, 4);
  const int right = hand_made::add_node(g, {1, 0}, NodeKind::crossing, 4);
  const int end = hand_made::add_node(g, unit(radians(170)), NodeKind::crossing, 4);
  const int stopped = hand_made::add_cut(g, 0, end);
  g.splines.push_back(curve::segment({-1, 0}, {1, 0}));
  const Nurbs& line = g.splines.back();
  const double middle = (line.begin() + line.end()) / 2;
  const int curve = g.face.num_curves() + 1;
  hand_made::add_arc(g, left, 0, false, {{curve, line.begin(), middle}});
  hand_made::add_arc(g, 0, right, false, {{curve, middle, line.end()}});
  const std::vector<HalfEdge> around = half_edges_around_nodes(g)[0];
  const std::vector<int> quarters = sector_quarters(g, 0, around);
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_beside = around[k].arc == stopped || around[(k + 1) % 3].arc == stopped;
    EXPECT_EQ(quarters[k], is_beside ? 1 : 2);
  }
}

TEST(Subdivision, OneBlockIsOneCycleOfItsFourSides) {
  const Subdivision subdivision(hand_made::unit_square());
  ASSERT_EQ(subdivision.num_faces(), 1);
  EXPECT_EQ(subdivision.cycle(0), (std::vector<HalfEdge>{{0}, {1}, {2}, {3}}));
  for (const HalfEdge h : subdivision.cycle(0)) EXPECT_EQ(subdivision.quarters(h), 1);
  EXPECT_EQ(subdivision.num_corners(0), 4);
  EXPECT_EQ(subdivision.num_components(), 1);
  EXPECT_EQ(subdivision.face({0, true}), -1);
}

TEST(Subdivision, EveryHalfEdgeInsideTheDomainLiesInOneCycle) {
  const Subdivision subdivision(hand_made::l_shape());
  std::vector<int> uses(2 * subdivision.arc_bound(), 0);
  for (int f = 0; f < subdivision.face_bound(); ++f)
    for (const HalfEdge h : subdivision.cycle(f)) {
      ++uses[h.index()];
      EXPECT_EQ(subdivision.face(h), f);
      EXPECT_EQ(subdivision.previous(subdivision.next(h)), h);
      EXPECT_EQ(subdivision.end(h), subdivision.start(subdivision.next(h)));
    }
  for (int a = 0; a < subdivision.arc_bound(); ++a) {
    EXPECT_EQ(uses[HalfEdge{a}.index()], 1);
    EXPECT_EQ(uses[(HalfEdge{a, true}.index())], subdivision.graph().arcs[a].is_boundary ? 0 : 1);
  }
}

TEST(Subdivision, CyclesAreCounterClockwise) {
  const Subdivision subdivision(hand_made::l_shape());
  const auto& nodes = subdivision.graph().nodes;
  for (int f = 0; f < subdivision.face_bound(); ++f) {
    double area = 0;
    for (const HalfEdge h : subdivision.cycle(f))
      area += cross(nodes[subdivision.start(h)].position, nodes[subdivision.end(h)].position);
    EXPECT_NEAR(area / 2, 1, 1e-14);  // three unit squares
  }
}

TEST(Subdivision, AroundABoundaryNodeTheBoundaryIsFirstAndLast) {
  const Subdivision subdivision(hand_made::l_shape());
  for (int n = 0; n < subdivision.node_bound(); ++n) {
    const std::vector<HalfEdge> around = subdivision.around(n);
    EXPECT_TRUE(!around.front().is_backwards && subdivision.graph().arcs[around.front().arc].is_boundary);
    EXPECT_TRUE(around.back().is_backwards && subdivision.graph().arcs[around.back().arc].is_boundary);
  }
  EXPECT_EQ(subdivision.around(3).size(), 4u);  // the reflex corner: two sides, two separatrices
}

TEST(Subdivision, ABoundaryThatDoesNotCloseIsRefused) {
  SeparatrixGraph graph = hand_made::unit_square();
  graph.arcs.pop_back();
  EXPECT_THROW(Subdivision{graph}, ComputeError);
}

}  // namespace
}  // namespace quadrille::graph
