#include "graph/build_graph.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::graph {
namespace {

using hand_made::face;

CadFace square() {
  return face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}), curve::segment({1, 1}, {0, 1}),
                curve::segment({0, 1}, {0, 0})}},
              std::sqrt(2.0));
}

std::vector<GraphNode> four_corners(const CadFace& f) {
  std::vector<GraphNode> nodes;
  for (int j = 0; j < 4; ++j) nodes.push_back({f.joints[j].position, NodeKind::corner, 1, j, f.curves[j].begin()});
  return nodes;
}

// A straight line between two places of the boundary.
FinishedLine line(const CadFace& f, int curve0, double t0, int curve1, double t1) {
  const Vec2 a = curve::point(f.curves[curve0], t0), b = curve::point(f.curves[curve1], t1);
  const double length = distance(a, b);
  return {{-1, curve0, t0},
          {-1, curve1, t1},
          curve::cubic_spline({0, length / 2, length}, {a, (a + b) / 2, b}, (b - a) / length, (b - a) / length),
          LineKind::traced};
}

SeparatrixGraph built(const CadFace& f, const std::vector<GraphNode>& fixed, const std::vector<FinishedLine>& lines) {
  std::vector<Nurbs> splines;
  for (const FinishedLine& l : lines) splines.push_back(l.spline);
  return build_graph(f, fixed, lines, find_crossings(splines, 1e-9), 1e-9);
}

TEST(BuildGraph, ASquareWithoutLinesIsOneFace) {
  const CadFace f = square();
  const SeparatrixGraph graph = built(f, four_corners(f), {});
  EXPECT_EQ(graph.nodes.size(), 4u);
  EXPECT_EQ(graph.arcs.size(), 4u);
  EXPECT_EQ(require_four_corners(Subdivision(graph)), 1);
}

TEST(BuildGraph, TwoCrossingLinesMakeFourBlocks) {
  const CadFace f = square();
  const SeparatrixGraph graph = built(f, four_corners(f), {line(f, 0, 0.3, 2, 0.6), line(f, 1, 0.5, 3, 0.4)});
  EXPECT_EQ(graph.nodes.size(), 9u);
  EXPECT_EQ(graph.arcs.size(), 12u);
  EXPECT_EQ(require_four_corners(Subdivision(graph)), 4);
  EXPECT_EQ(graph.nodes.back().kind, NodeKind::crossing);
  for (const SeparatrixLine& l : graph.lines) EXPECT_EQ(l.arcs.size(), 2u);
}

TEST(BuildGraph, ArcsEndInTheirNodes) {
  const CadFace f = square();
  const SeparatrixGraph graph = built(f, four_corners(f), {line(f, 0, 0.3, 2, 0.6), line(f, 1, 0.5, 3, 0.4)});
  for (const GraphArc& arc : graph.arcs) {
    const ArcPiece &first = arc.pieces.front(), &last = arc.pieces.back();
    EXPECT_LT(distance(curve::point(graph.curve(first.curve), first.t0), graph.nodes[arc.from].position), 1e-14);
    EXPECT_LT(distance(curve::point(graph.curve(last.curve), last.t1), graph.nodes[arc.to].position), 1e-14);
  }
}

TEST(BuildGraph, JointsWithoutNodeLieInsideAnArc) {
  const CadFace f = hand_made::s_bend().face;
  std::vector<GraphNode> fixed;
  for (int j = 0; j < f.num_curves(); ++j)
    if (f.joints[j].is_corner) fixed.push_back({f.joints[j].position, NodeKind::corner, 1, j, f.curves[j].begin()});
  const SeparatrixGraph graph = built(f, fixed, {});
  ASSERT_EQ(graph.arcs.size(), 4u);
  EXPECT_EQ(graph.arcs[0].pieces.size(), 5u);
  EXPECT_EQ(graph.arcs[1].pieces.size(), 1u);
  EXPECT_EQ(require_four_corners(Subdivision(graph)), 1);
}

TEST(BuildGraph, EndsNearEachOtherAndNearJointsAreOneNode) {
  // A square whose bottom is two curves with a smooth joint at (0.5, 0).
  const CadFace f =
      face({{curve::segment({0, 0}, {0.5, 0}), curve::segment({0.5, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}),
             curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
           std::sqrt(2.0));
  std::vector<GraphNode> fixed;
  for (const int j : {0, 2, 3, 4}) fixed.push_back({f.joints[j].position, NodeKind::corner, 1, j, f.curves[j].begin()});
  const SeparatrixGraph graph = built(f, fixed, {line(f, 0, 0.5 - 2e-10, 3, 0.5)});
  ASSERT_EQ(graph.nodes.size(), 6u);
  EXPECT_EQ(graph.nodes[4].position, (Vec2{0.5, 0}));
  EXPECT_EQ(graph.nodes[4].curve, 1);
  EXPECT_EQ(graph.splines[0].poles.front(), (Vec2{0.5, 0}));
  EXPECT_EQ(require_four_corners(Subdivision(graph)), 2);
}

TEST(BuildGraph, AClosedLoopWithOneNodeIsOneArc) {
  const CadFace f = face({{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}}, 2);
  const SeparatrixGraph graph = built(f, {}, {});
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].from, graph.arcs[0].to);
  EXPECT_THROW(require_four_corners(Subdivision(graph)), ComputeError);
}

TEST(BuildGraph, ALineThroughTheEndOfAnotherIsRefused) {
  const CadFace f = square();
  FinishedLine half = line(f, 1, 0.5, 3, 0.5);
  // Ends at (0.5, 0.5) in a node of its own, on the way of the other line.
  half.spline = curve::cubic_spline({0, 0.25, 0.5}, {{1, 0.5}, {0.75, 0.5}, {0.5, 0.5}}, {-1, 0}, {-1, 0});
  std::vector<GraphNode> fixed = four_corners(f);
  fixed.push_back({{0.5, 0.5}, NodeKind::irregular, 3, -1});
  half.end = {4, -1, 0};
  EXPECT_THROW(built(f, fixed, {half, line(f, 0, 0.5, 2, 0.5)}), ComputeError);
}

// A house: five corners of valence 1 and one node of valence 3 in the middle of its floor make three blocks.
struct House : testing::Test {
  CadFace f = face({{curve::segment({0, 0}, {2, 0}), curve::segment({2, 0}, {2, 1}), curve::segment({2, 1}, {1, 2}),
                     curve::segment({1, 2}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                   2 * std::sqrt(2.0));
  GraphNode floor{{1, 0}, NodeKind::boundary, 3, 0, 1};

  std::vector<GraphNode> fixed() const {
    std::vector<GraphNode> nodes;
    for (int j = 0; j < 5; ++j) nodes.push_back({f.joints[j].position, NodeKind::corner, 1, j, f.curves[j].begin()});
    nodes.push_back(floor);
    return nodes;
  }
};

TEST_F(House, ANodeOnTheBoundarySplitsItAndCountsItsSectors) {
  FinishedLine right = line(f, 0, 1, 2, 0.7), left = line(f, 0, 1, 3, 0.7);
  right.start = left.start = {5, -1, 0};
  const SeparatrixGraph graph = built(f, fixed(), {right, left});
  EXPECT_EQ(graph.nodes.size(), 8u);
  EXPECT_EQ(graph.nodes[5].curve, 0);
  EXPECT_EQ(graph.nodes[5].valence, 3);
  EXPECT_EQ(require_four_corners(Subdivision(graph)), 3);
}

TEST_F(House, LinesThatEndBesideANodeOnTheBoundaryEndInIt) {
  const SeparatrixGraph graph = built(f, fixed(), {line(f, 2, 0.7, 0, 1 + 5e-10), line(f, 3, 0.7, 0, 1 - 5e-10)});
  EXPECT_EQ(graph.nodes.size(), 8u);
  for (const SeparatrixLine& l : graph.lines) EXPECT_EQ(l.end, 5);
  EXPECT_EQ(require_four_corners(Subdivision(graph)), 3);
}

TEST_F(House, ANodeAtASmoothJointIsTheSame) {
  f = face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {2, 0}), curve::segment({2, 0}, {2, 1}),
             curve::segment({2, 1}, {1, 2}), curve::segment({1, 2}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
           2 * std::sqrt(2.0));
  std::vector<GraphNode> nodes;
  for (const int j : {0, 2, 3, 4, 5})
    nodes.push_back({f.joints[j].position, NodeKind::corner, 1, j, f.curves[j].begin()});
  nodes.push_back({{1, 0}, NodeKind::boundary, 3, 1});
  FinishedLine right = line(f, 1, 0, 3, 0.7);
  right.start = {5, -1, 0};
  const SeparatrixGraph graph = built(f, nodes, {right, line(f, 4, 0.7, 0, 1 - 5e-10)});
  EXPECT_EQ(graph.nodes.size(), 8u);
  EXPECT_EQ(require_four_corners(Subdivision(graph)), 3);
}

TEST_F(House, WithoutItsLinesTheNodeIsAReflexCorner) {
  EXPECT_THROW(require_four_corners(Subdivision(built(f, fixed(), {}))), ComputeError);
}

}  // namespace
}  // namespace quadrille::graph
