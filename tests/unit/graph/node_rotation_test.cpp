#include "graph/node_rotation.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/angle.hpp"

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

}  // namespace
}  // namespace quadrille::graph
