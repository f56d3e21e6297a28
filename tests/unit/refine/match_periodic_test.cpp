#include "refine/match_periodic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/grid_layout.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "block/make_blocks.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::refine {
namespace {

using layers::parse_wall_spec;

/// Two blocks on top of each other, on the left of a wave: [0, w(y)] x [0, 2]; the top is the bottom moved by (0, 2).
SeparatrixGraph wavy_column() {
  const Nurbs wave{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {2.2, 0.8}, {1, 2}}, {1, 1, 1}};
  SeparatrixGraph g = hand_made::one_block(
      hand_made::face(
          {{curve::segment({0, 0}, {1, 0}), wave, curve::segment({1, 2}, {0, 2}), curve::segment({0, 2}, {0, 0})}},
          std::sqrt(8.0)),
      {{0}, {1}, {2}, {3}});
  g.face.periodic_pairs = {{{0, 2}, 0, {0, 2}}};
  return g;
}

/// A sector of a ring from the angle 0 to a third turn; both straight sides are periodic.
SeparatrixGraph sector() {
  const double angle = 2 * pi / 3;
  const Vec2 end = unit(angle);
  SeparatrixGraph g =
      hand_made::one_block(hand_made::face({{curve::segment({1, 0}, {2, 0}), curve::circular_arc({0, 0}, 2, 0, angle),
                                             curve::segment(2 * end, end), curve::circular_arc({0, 0}, 1, angle, 0)}},
                                           4),
                           {{0}, {1}, {2}, {3}});
  g.face.periodic_pairs = {{{0, 2}, angle, {0, 0}}};
  return g;
}

/// Greatest distance of a node of the first curve, moved, from the nearest of the second, in diameters.
double greatest_gap(const QuadMesh& mesh, const PeriodicPair& pair) {
  std::vector<Vec2> second;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    if (e.curve == pair.curves[1])
      for (const int node : side_nodes(mesh, e.elem, e.side)) second.push_back(mesh.nodes[node]);
  double greatest = 0;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges) {
    if (e.curve != pair.curves[0]) continue;
    for (const int node : side_nodes(mesh, e.elem, e.side)) {
      const Vec2 x = mesh.nodes[node], turn = unit(pair.angle);
      const Vec2 image = Vec2{turn.x * x.x - turn.y * x.y, turn.y * x.x + turn.x * x.y} + pair.shift;
      double nearest = 1e300;
      for (const Vec2 y : second) nearest = std::min(nearest, distance(image, y));
      greatest = std::max(greatest, nearest);
    }
  }
  return greatest / mesh.face.diameter;
}

TEST(MatchPeriodic, BothArcsGetTheMean) {
  std::vector<double> first{0, 0.25, 0.5, 1}, second{0, 0.5, 0.625, 1};
  match_fractions({HalfEdge{0}, HalfEdge{1}}, first, second);
  EXPECT_EQ(first, (std::vector<double>{0, 0.3125, 0.5, 1}));
  EXPECT_EQ(second, (std::vector<double>{0, 0.5, 0.6875, 1}));
  first = {0, 0.25, 1}, second = {0, 0.5, 1};
  match_fractions({HalfEdge{0}, HalfEdge{1, true}}, first, second);
  EXPECT_EQ(first, second);
  EXPECT_EQ(first[1], 0.375);
}

TEST(MatchPeriodic, ArcsOfAPairAreOneChord) {
  const BlockLayout layout = block::extract_blocks(sector());
  const std::vector<PeriodicArcs> pairs = matched_arcs(layout);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0], (PeriodicArcs{HalfEdge{0}, HalfEdge{2}}));
  EXPECT_EQ(layout.arc_chord[0], layout.arc_chord[2]);
}

TEST(MatchPeriodic, NodesAreMappedOntoEachOther) {
  for (const SeparatrixGraph& graph : {sector(), wavy_column()}) {
    RefineOptions options{.size = 0.2, .order = 4};
    options.size_field = sizing::SizeField(0.2, {{{{1, 0}, 0.03, 0}}, {}, 0}, {}, 1.3);
    EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
    options.relax = 5;
    EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
  }
}

TEST(MatchPeriodic, WithLayersAtOneEndToo) {
  RefineOptions options{.size = 0.3, .order = 3};
  options.walls = {parse_wall_spec("side_1:first=0.02,layers=3")};
  for (const SeparatrixGraph& graph : {sector(), wavy_column()})
    EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
}

/// [0, 3] x [0, 4], periodic upwards, in two blocks: the line between them has a bump on the left, nearer to the
/// bottom, to which the lines from the bottom bend more than those from the top.
SeparatrixGraph bumpy_column() {
  SeparatrixGraph g;
  g.face = hand_made::face({{curve::segment({0, 0}, {3, 0}), curve::segment({3, 0}, {3, 4}),
                             curve::segment({3, 4}, {0, 4}), curve::segment({0, 4}, {0, 0})}},
                           5);
  g.face.periodic_pairs = {{{0, 2}, 0, {0, 4}}};
  for (int k = 0; k < 4; ++k) hand_made::add_joint_node(g, k);
  const int right = hand_made::add_boundary_node(g, 1, 1), left = hand_made::add_boundary_node(g, 3, 3);
  hand_made::add_arc(g, 0, 1, true, {{0, 0, 3}});
  hand_made::add_arc(g, 1, right, true, {{1, 0, 1}});
  hand_made::add_arc(g, right, 2, true, {{1, 1, 4}});
  hand_made::add_arc(g, 2, 3, true, {{2, 0, 3}});
  hand_made::add_arc(g, 3, left, true, {{3, 0, 3}});
  hand_made::add_arc(g, left, 0, true, {{3, 3, 4}});
  g.splines.push_back({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 1}, {0.2, 2.6}, {0.6, 1}, {3, 1}}, {1, 1, 1, 1}});
  hand_made::add_arc(g, left, right, false, {{4, 0, 1}});
  return g;
}

TEST(MatchPeriodic, WhereTheBlocksBesideDiffer) {
  const SeparatrixGraph graph = bumpy_column();
  RefineOptions options{.size = 0.25, .order = 3};
  EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
  options.walls = {parse_wall_spec("side_3:first=0.02,layers=3")};
  EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
}

/// The plate [0, 3] x [0, 2] in unit squares, periodic to the right. The blocks on the left and on the right are
/// linked: a count on the right counts on the left.
SeparatrixGraph periodic_grid() {
  SeparatrixGraph g = grid_layout(3, 2);
  g.face.periodic_pairs = {{{1, 3}, 0, {-3, 0}}};
  return g;
}

TEST(MatchPeriodic, SizesOnOneSideActOnTheOther) {
  const SeparatrixGraph graph = periodic_grid();
  RefineOptions options{.size = 0.5, .order = 2};
  options.size_field = sizing::SizeField(0.5, {{{{3, 0.5}, 0.05, 0.1}}, {}, 0}, {}, 1.3);
  const QuadMesh mesh = refined(graph, options);
  EXPECT_LT(greatest_gap(mesh, graph.face.periodic_pairs[0]), 1e-13);
  EXPECT_LT(greatest_gap(mesh, {{3, 1}, 0, {3, 0}}), 1e-13) << "and as many";
}

TEST(MatchPeriodic, CutsOfAChordMatch) {
  graph::Subdivision subdivision = block::subdivision_into_blocks(periodic_grid());
  int right = 0;
  while (subdivision.graph().arcs[right].pieces.front().curve != 1) ++right;
  ASSERT_TRUE(block::split_chord(subdivision, right, std::vector<bool>(6, true)));
  EXPECT_NO_THROW(require_periodic_arcs(subdivision.graph(), ""));
  EXPECT_EQ(periodic_arcs(subdivision.graph()).size(), 3u);
}

TEST(MatchPeriodic, BlocksThatDoNotMatchAreRefused) {
  SeparatrixGraph graph = periodic_grid();
  graph.face.periodic_pairs = {{{0, 1}, 0, {0, 0}}};
  try {
    refined(graph, {.size = 0.5});
    FAIL() << "accepted";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("has no counterpart"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace quadrille::refine
