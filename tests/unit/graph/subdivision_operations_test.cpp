#include <gtest/gtest.h>

#include <random>
#include <tuple>

#include "../hand_made.hpp"
#include "../support/grid_layout.hpp"
#include "base/error.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/subdivision.hpp"

namespace quadrille::graph {
namespace {

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

TEST(SubdivisionOperations, DividedArcsAreAsBuiltAndDissolveAgain) {
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

TEST(SubdivisionOperations, NodesWithOtherArcsAreNotDissolved) {
  Subdivision subdivision(grid_layout(2, 2));
  for (int n = 0; n < subdivision.node_bound(); ++n) EXPECT_FALSE(subdivision.dissolve_node(n));
  expect_as_built(subdivision);
}

TEST(SubdivisionOperations, ABlockIsDividedAndUnitedAgain) {
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

TEST(SubdivisionOperations, AnArcWithOneFaceOnBothSidesIsNotRemoved) {
  Subdivision subdivision(hand_made::cut_annulus(1));
  EXPECT_FALSE(subdivision.remove_arc(2));
  EXPECT_FALSE(subdivision.remove_arc(0));  // the boundary
  expect_as_built(subdivision);
}

TEST(SubdivisionOperations, ACollapsedColumnIsAsBuilt) {
  for (const double column : {0.0, 1.0, 2.0}) {
    Subdivision subdivision(grid_layout(4, 3));
    collapse_column(subdivision, column);
    EXPECT_EQ(subdivision.num_faces(), 9);
    expect_as_built(subdivision);
  }
}

TEST(SubdivisionOperations, NodesThatMustNotMergeAreRefused) {
  Subdivision subdivision(grid_layout(2, 1));
  int inner = 0;
  while (subdivision.graph().arcs[inner].is_boundary) ++inner;
  EXPECT_THROW(subdivision.merge_ends({inner}), Defect);  // two nodes of the boundary
}

TEST(SubdivisionOperations, AReshapedArcRunsInTheNewDirection) {
  Subdivision subdivision(grid_layout(2, 2));
  int inner = 0;
  while (subdivision.graph().arcs[inner].is_boundary) ++inner;
  const int from = subdivision.start({inner}), to = subdivision.end({inner});
  subdivision.reshape_arc({inner, true}, reversed_pieces(subdivision.graph().arcs[inner].pieces));
  EXPECT_EQ(subdivision.start({inner}), to);
  EXPECT_EQ(subdivision.end({inner}), from);
  expect_as_built(subdivision);
}

TEST(SubdivisionOperations, ACopyIsIndependent) {
  const Subdivision original(grid_layout(2, 2));
  Subdivision copy = original;
  collapse_column(copy, 0);
  EXPECT_EQ(original.num_faces(), 4);
  expect_as_built(original);
}

TEST(SubdivisionOperations, OnlyUnusedSplinesAreDropped) {
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

TEST(SubdivisionOperations, RandomOperationsLeaveWhatTheGraphGives) {
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

TEST(SubdivisionOperations, ATrialThatIsUndoneLeavesNothing) {
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

TEST(SubdivisionOperations, ATrialCollapsesAndDividesAndIsUndone) {
  Subdivision subdivision(grid_layout(4, 3));
  const Subdivision before = subdivision;
  subdivision.begin_trial();
  collapse_column(subdivision, 1);
  divide_block(subdivision, 0, 0);
  subdivision.undo_trial();
  expect_same(subdivision, before);
}

TEST(SubdivisionOperations, ATrialThatIsKeptIsAsBuilt) {
  Subdivision subdivision(grid_layout(4, 3));
  subdivision.begin_trial();
  collapse_column(subdivision, 2);
  subdivision.keep_trial();
  EXPECT_EQ(subdivision.num_faces(), 9);
  expect_as_built(subdivision);
}

}  // namespace
}  // namespace quadrille::graph
