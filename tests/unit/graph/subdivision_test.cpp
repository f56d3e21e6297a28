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

// What operations and compact() have made is what the graph itself gives.
void expect_as_built(Subdivision subdivision) {
  subdivision.compact();
  const Subdivision built(subdivision.graph());
  ASSERT_EQ(subdivision.arc_bound(), built.arc_bound());
  EXPECT_EQ(subdivision.num_faces(), built.num_faces());
  EXPECT_EQ(subdivision.face_bound(), built.face_bound());
  EXPECT_EQ(subdivision.num_components(), built.num_components());
  for (int a = 0; a < built.arc_bound(); ++a)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}}) {
      EXPECT_EQ(subdivision.next(h), built.next(h)) << a;
      EXPECT_EQ(subdivision.face(h), built.face(h)) << a;
      EXPECT_EQ(subdivision.quarters(h), built.quarters(h)) << a;
    }
  for (int f = 0; f < built.face_bound(); ++f) EXPECT_EQ(subdivision.cycle(f), built.cycle(f));
  for (int n = 0; n < built.node_bound(); ++n) {
    const std::vector<HalfEdge> around = subdivision.around(n);
    ASSERT_FALSE(around.empty());
    for (const HalfEdge h : around) EXPECT_EQ(subdivision.start(h), n);
    int quarters = 0;
    for (const HalfEdge h : around) quarters += subdivision.quarters(h.reversed());
    EXPECT_EQ(quarters, subdivision.graph().nodes[n].valence);
  }
}

// A straight arc between two nodes, as a spline of its own.
std::vector<ArcPiece> straight(Subdivision& subdivision, int from, int to) {
  const std::vector<GraphNode>& nodes = subdivision.graph().nodes;
  Nurbs segment = curve::segment(nodes[from].position, nodes[to].position);
  const double begin = segment.begin(), end = segment.end();
  return {{subdivision.add_spline(std::move(segment)), begin, end}};
}

// Divides the one piece of an arc at the fraction f of its parameters, forwards.
Subdivision::Division divide(Subdivision& subdivision, int arc, double f) {
  const GraphArc& a = subdivision.graph().arcs[arc];
  const ArcPiece p = a.pieces.front();
  const double t = p.t0 + f * (p.t1 - p.t0);
  const Vec2 x = curve::point(subdivision.graph().curve(p.curve), t);
  const GraphNode node =
      a.is_boundary ? GraphNode{x, NodeKind::boundary, 2, p.curve, t} : GraphNode{x, NodeKind::crossing, 4, -1, 0};
  return subdivision.divide_arc({arc}, node, {{p.curve, p.t0, t}}, {{p.curve, t, p.t1}});
}

// A line through the middle of a block, from side k to side k + 2 of its cycle.
void divide_block(Subdivision& subdivision, int face, int k) {
  const std::vector<HalfEdge> cycle = subdivision.cycle(face);
  const Subdivision::Division near = divide(subdivision, cycle[k].arc, 0.5);
  const Subdivision::Division far = divide(subdivision, cycle[k + 2].arc, 0.5);
  // The halves that end in the new nodes, with the block on their left.
  const auto half = [](HalfEdge side, const Subdivision::Division& d) {
    return side.is_backwards ? d.second.reversed() : d.first;
  };
  subdivision.insert_arc({half(cycle[k], near), 1}, {half(cycle[k + 2], far), 1},
                         straight(subdivision, near.node, far.node));
}

// All rungs of a column of blocks (between x = column and column + 1) are shrunk to their left ends.
void collapse_column(Subdivision& subdivision, double column) {
  const ArcGraph before = subdivision.graph();
  std::vector<int> rails;
  for (int a = 0; a < subdivision.arc_bound(); ++a) {
    const Vec2 from = before.nodes[before.arcs[a].from].position, to = before.nodes[before.arcs[a].to].position;
    if (from.x == column + 1 && to.x == column + 1) rails.push_back(a);
  }
  for (int a = 0; a < subdivision.arc_bound(); ++a) {
    const Vec2 from = before.nodes[before.arcs[a].from].position, to = before.nodes[before.arcs[a].to].position;
    if (std::min(from.x, to.x) != column || std::max(from.x, to.x) != column + 1) continue;
    const HalfEdge rung{a, from.x > to.x};
    const Pieces pieces = pieces_along(subdivision.graph(), rung);
    for (const HalfEdge h : subdivision.around(subdivision.end(rung))) {
      const Vec2 end = before.nodes[subdivision.end(h)].position;
      if (end.x <= column + 1) continue;
      const Pieces& own = subdivision.graph().arcs[h.arc].pieces;
      subdivision.set_pieces(h.arc, h.is_backwards ? joined(own, reversed_pieces(pieces)) : joined(pieces, own));
    }
    subdivision.merge_ends(rung);
  }
  for (const int a : rails) EXPECT_TRUE(subdivision.remove_arc(a));
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

TEST(Subdivision, DividedArcsAreAsBuiltAndDissolveAgain) {
  for (const SeparatrixGraph& graph : {grid_layout(3, 2), hand_made::l_shape(), hand_made::cut_annulus(4)})
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
      Subdivision subdivision(graph);
      const Subdivision::Division d = divide(subdivision, a, 0.25);
      EXPECT_EQ(d.first.arc, a);
      EXPECT_EQ(subdivision.end(d.first), d.node);
      EXPECT_EQ(subdivision.start(d.second), d.node);
      expect_as_built(subdivision);
      EXPECT_TRUE(subdivision.dissolve_node(d.node));
      expect_as_built(subdivision);
      EXPECT_EQ(subdivision.graph().arcs.back().pieces.size(), 1u);
    }
}

TEST(Subdivision, NodesWithOtherArcsAreNotDissolved) {
  Subdivision subdivision(grid_layout(2, 2));
  for (int n = 0; n < subdivision.node_bound(); ++n) EXPECT_FALSE(subdivision.dissolve_node(n));
  expect_as_built(subdivision);
}

TEST(Subdivision, ABlockIsDividedAndUnitedAgain) {
  for (const int k : {0, 1}) {
    Subdivision subdivision(grid_layout(3, 3));
    divide_block(subdivision, 4, k);
    EXPECT_EQ(subdivision.num_faces(), 10);
    expect_as_built(subdivision);
    EXPECT_TRUE(subdivision.remove_arc(subdivision.arc_bound() - 1));
    EXPECT_EQ(subdivision.num_faces(), 9);
    expect_as_built(subdivision);
  }
}

TEST(Subdivision, AnArcWithOneFaceOnBothSidesIsNotRemoved) {
  Subdivision subdivision(hand_made::cut_annulus(1));
  EXPECT_FALSE(subdivision.remove_arc(2));
  EXPECT_FALSE(subdivision.remove_arc(0));  // the boundary
  expect_as_built(subdivision);
}

TEST(Subdivision, ACollapsedColumnIsAsBuilt) {
  for (const double column : {0.0, 1.0, 2.0}) {
    Subdivision subdivision(grid_layout(4, 3));
    collapse_column(subdivision, column);
    EXPECT_EQ(subdivision.num_faces(), 9);
    expect_as_built(subdivision);
  }
}

TEST(Subdivision, NodesThatMustNotMergeAreRefused) {
  Subdivision subdivision(grid_layout(2, 1));
  int inner = 0;
  while (subdivision.graph().arcs[inner].is_boundary) ++inner;
  EXPECT_THROW(subdivision.merge_ends({inner}), Defect);  // two nodes of the boundary
}

TEST(Subdivision, AReshapedArcRunsInTheNewDirection) {
  Subdivision subdivision(grid_layout(2, 2));
  int inner = 0;
  while (subdivision.graph().arcs[inner].is_boundary) ++inner;
  const int from = subdivision.start({inner}), to = subdivision.end({inner});
  subdivision.reshape_arc({inner, true}, reversed_pieces(subdivision.graph().arcs[inner].pieces));
  EXPECT_EQ(subdivision.start({inner}), to);
  EXPECT_EQ(subdivision.end({inner}), from);
  expect_as_built(subdivision);
}

TEST(Subdivision, ACopyIsIndependent) {
  const Subdivision original(grid_layout(2, 2));
  Subdivision copy = original;
  collapse_column(copy, 0);
  EXPECT_EQ(original.num_faces(), 4);
  expect_as_built(original);
}

TEST(Subdivision, OnlyUnusedSplinesAreDropped) {
  Subdivision subdivision(grid_layout(2, 2));
  const std::size_t used = subdivision.graph().splines.size();
  subdivision.add_spline(curve::segment({0, 0}, {1, 1}));
  subdivision.drop_unused_splines();
  EXPECT_EQ(subdivision.graph().splines.size(), used);
}

// Divisions, removals and flips in any order.
void change_at_random(Subdivision& subdivision, std::mt19937& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<int> nodes;
  for (int i = 0; i < 12; ++i) {
    const int arc = below(subdivision.arc_bound());
    if (!subdivision.has_arc(arc)) continue;
    const bool is_inner = !subdivision.graph().arcs[arc].is_boundary;
    switch (below(4)) {
      case 0:
        nodes.push_back(divide(subdivision, arc, 0.5).node);
        break;
      case 1:
        subdivision.remove_arc(arc);
        break;
      case 2:
        if (is_inner) subdivision.reshape_arc({arc, true}, reversed_pieces(subdivision.graph().arcs[arc].pieces));
        break;
      default:
        if (!nodes.empty()) subdivision.dissolve_node(nodes[below(static_cast<int>(nodes.size()))]);
    }
  }
}

Subdivision random_grid(std::mt19937& random) {
  const int columns = 2 + static_cast<int>(random() % 3u);
  return Subdivision(grid_layout(columns, 2 + static_cast<int>(random() % 3u)));
}

TEST(Subdivision, RandomOperationsLeaveWhatTheGraphGives) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    Subdivision subdivision = random_grid(random);
    change_at_random(subdivision, random);
    expect_as_built(subdivision);
  }
}

void expect_same(const Subdivision& a, const Subdivision& b) {
  ASSERT_EQ(a.arc_bound(), b.arc_bound());
  ASSERT_EQ(a.node_bound(), b.node_bound());
  ASSERT_EQ(a.face_bound(), b.face_bound());
  EXPECT_EQ(a.graph().splines.size(), b.graph().splines.size());
  for (int arc = 0; arc < a.arc_bound(); ++arc) {
    const GraphArc &p = a.graph().arcs[arc], &q = b.graph().arcs[arc];
    EXPECT_EQ(std::tie(p.from, p.to, p.is_boundary), std::tie(q.from, q.to, q.is_boundary));
    ASSERT_EQ(p.pieces.size(), q.pieces.size());
    for (std::size_t i = 0; i < p.pieces.size(); ++i)
      EXPECT_EQ(std::tie(p.pieces[i].curve, p.pieces[i].t0, p.pieces[i].t1),
                std::tie(q.pieces[i].curve, q.pieces[i].t0, q.pieces[i].t1));
    for (const HalfEdge h : {HalfEdge{arc}, HalfEdge{arc, true}}) {
      EXPECT_EQ(a.next(h), b.next(h));
      EXPECT_EQ(a.face(h), b.face(h));
      EXPECT_EQ(a.quarters(h), b.quarters(h));
    }
  }
  for (int n = 0; n < a.node_bound(); ++n) {
    EXPECT_EQ(a.graph().nodes[n].position, b.graph().nodes[n].position);
    EXPECT_EQ(a.graph().nodes[n].valence, b.graph().nodes[n].valence);
    EXPECT_EQ(a.around(n), b.around(n));
  }
  for (int f = 0; f < a.face_bound(); ++f) EXPECT_EQ(a.cycle(f), b.cycle(f));
}

TEST(Subdivision, ATrialThatIsUndoneLeavesNothing) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    Subdivision subdivision = random_grid(random);
    change_at_random(subdivision, random);
    const Subdivision before = subdivision;
    subdivision.begin_trial();
    change_at_random(subdivision, random);
    subdivision.move_node(0, {9, 9});
    subdivision.undo_trial();
    expect_same(subdivision, before);
    change_at_random(subdivision, random);
    expect_as_built(subdivision);
  }
}

TEST(Subdivision, ATrialCollapsesAndDividesAndIsUndone) {
  Subdivision subdivision(grid_layout(4, 3));
  const Subdivision before = subdivision;
  subdivision.begin_trial();
  collapse_column(subdivision, 1);
  divide_block(subdivision, 0, 0);
  subdivision.undo_trial();
  expect_same(subdivision, before);
}

TEST(Subdivision, ATrialThatIsKeptIsAsBuilt) {
  Subdivision subdivision(grid_layout(4, 3));
  subdivision.begin_trial();
  collapse_column(subdivision, 2);
  subdivision.keep_trial();
  EXPECT_EQ(subdivision.num_faces(), 9);
  expect_as_built(subdivision);
}

}  // namespace
}  // namespace quadrille::graph
