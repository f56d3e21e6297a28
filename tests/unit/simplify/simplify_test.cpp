#include "simplify/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_made.hpp"
#include "../support/square_field.hpp"
#include "graph/build_graph.hpp"
#include "simplify/chord_collapse.hpp"
#include "simplify/chord_judge.hpp"
#include "simplify/chord_shortcut.hpp"

namespace quadrille::simplify {
namespace {

// A hall with an arm on either side, whose floors lie at the heights 1 and 1 + `step`: the lines that run along the
// hall from the reflex corners P = (1, 1) and Q = (3, 1 + step) leave a strip of two blocks between them.
//
//     (0,2) ------------------------------- (4,2)
//       |      |                  |           |
//       | .  . | .  .  .  .  .  . Q --------(4,1+step)
//     (0,1) -- P .  .  .  .  .  . |
//              |                  |
//            (1,0) ------------ (3,0)
SeparatrixGraph hall(double step) {
  const std::vector<Vec2> corners{{1, 0}, {3, 0}, {3, 1 + step}, {4, 1 + step}, {4, 2}, {0, 2}, {0, 1}, {1, 1}};
  std::vector<Nurbs> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) loop.push_back(curve::segment(corners[i], corners[(i + 1) % 8]));
  const CadFace f = hand_made::face({loop}, std::sqrt(20.0));
  std::vector<graph::FixedNode> fixed;
  for (int j = 0; j < 8; ++j) fixed.push_back({corners[j], NodeKind::corner, j == 2 || j == 7 ? 3 : 1, j});
  const auto line = [&](int from, int curve, double t) {
    const Vec2 a = corners[from], b = curve::point(f.curves[curve], t), along = normalized(b - a);
    const double length = distance(a, b);
    return graph::FinishedLine{{from, -1, 0},
                               {-1, curve, t},
                               curve::cubic_spline({0, length / 2, length}, {a, (a + b) / 2, b}, along, along),
                               "traced"};
  };
  const std::vector<graph::FinishedLine> lines{line(7, 1, 1), line(7, 4, 3), line(2, 5, 1 - step), line(2, 4, 1)};
  std::vector<Nurbs> splines;
  for (const graph::FinishedLine& l : lines) splines.push_back(l.spline);
  return graph::build_graph(f, fixed, lines, graph::find_crossings(splines, 1e-9), 1e-9);
}

struct Hall : testing::Test {
  const double step = 0.1;
  SeparatrixGraph graph = hall(step);
  // The field need not end where the hall does.
  Field field = interpolated_field(square_mesh({-1, -2}, 6, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  SimplifyOptions options;
  Report report;

  // The strip between P's line and Q's, whose blocks have the height of the step.
  graph::ChordStrip thin_strip() const {
    const graph::PlanarFaces faces = graph::planar_faces(graph);
    for (const graph::ChordStrip& strip : graph::all_strips(graph, faces, graph::arc_lengths(graph)))
      if (strip.width < 1.5 * step) return strip;
    return {};
  }
};

double turn_of_hall(double step) { return std::atan(half_pi * step / 2); }

TEST_F(Hall, HasSixBlocksInSixStrips) {
  const graph::PlanarFaces faces = graph::planar_faces(graph);
  EXPECT_EQ(graph::require_four_corners(graph), 6);
  const auto strips = graph::all_strips(graph, faces, graph::arc_lengths(graph));
  EXPECT_EQ(strips.size(), 6u);
  std::size_t blocks = 0;
  for (const graph::ChordStrip& strip : strips) {
    EXPECT_FALSE(strip.is_closed);
    EXPECT_EQ(strip.rungs.size(), strip.blocks.size() + 1);
    blocks += strip.blocks.size();
  }
  EXPECT_EQ(blocks, 12u);  // each in two
}

TEST_F(Hall, TheThinStripIsPinnedByACornerAtEachRung) {
  const graph::ChordStrip strip = thin_strip();
  ASSERT_EQ(strip.num_blocks(), 2);
  EXPECT_NEAR(strip.width, step, 1e-12);
  EXPECT_NEAR(strip.length, 3, 1e-12);
  const std::vector<graph::Pin> pins = graph::pins_of(graph, strip);
  ASSERT_EQ(pins.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const int pinned =
        pins[i] == graph::Pin::left ? start_of(graph.arcs, strip.rungs[i]) : end_of(graph.arcs, strip.rungs[i]);
    EXPECT_EQ(graph.nodes[pinned].kind, NodeKind::corner);
  }
  // P and the floor's other end on one side, Q on the other.
  EXPECT_NE(std::count(pins.begin(), pins.end(), graph::Pin::left), 3);
  EXPECT_NE(std::count(pins.begin(), pins.end(), graph::Pin::right), 3);
}

TEST_F(Hall, AStripIsTheSameFromEachOfItsRungs) {
  const graph::PlanarFaces faces = graph::planar_faces(graph);
  const graph::ChordStrip strip = thin_strip();
  for (const HalfEdge rung : strip.rungs) EXPECT_EQ(graph::strip_through(graph, faces, rung.arc).rungs, strip.rungs);
}

TEST_F(Hall, TheStripBecomesOneLineBetweenTheReflexCorners) {
  const SeparatrixGraph simple = simplify(evaluator, graph, options, report);
  EXPECT_EQ(graph::require_four_corners(simple), 4);
  EXPECT_EQ(simple.nodes.size(), graph.nodes.size() - 3);
  EXPECT_EQ(simple.splines.size(), 3u);
  const Nurbs* blend = nullptr;
  for (const SeparatrixLine& line : simple.lines)
    if (line.kind == "merged") {
      ASSERT_EQ(line.arcs.size(), 1u);
      blend = &simple.curve(simple.arcs[line.arcs[0]].pieces[0].curve);
    }
  ASSERT_NE(blend, nullptr);
  const bool is_from_p = blend->poles.front().x < 2;
  for (int i = 0; i <= 20; ++i) {
    const double f = i / 20.0, along = is_from_p ? f : 1 - f;
    const Vec2 exact{1 + 2 * along, 1 + step * std::pow(std::sin(half_pi * along), 2)};
    EXPECT_LT(distance(curve::point(*blend, blend->begin() + f * (blend->end() - blend->begin())), exact), 1e-8);
  }
}

TEST_F(Hall, LinesAcrossStayWhereTheyAre) {
  const SeparatrixGraph simple = simplify(evaluator, graph, options, report);
  for (const double x : {1.0, 3.0}) {
    bool found = false;
    for (const GraphArc& arc : simple.arcs) {
      if (arc.is_boundary || simple.nodes[arc.from].position.x != x || simple.nodes[arc.to].position.x != x) continue;
      ASSERT_EQ(arc.pieces.size(), 1u);  // what was cut where the strip lay is one again
      const double low = std::min(simple.nodes[arc.from].position.y, simple.nodes[arc.to].position.y);
      EXPECT_EQ(low, x == 1 ? 1 : 1 + step);
      found = true;
    }
    EXPECT_TRUE(found);
  }
}

TEST_F(Hall, TheBoundaryIsStillCoveredOnce) {
  const SeparatrixGraph simple = simplify(evaluator, graph, options, report);
  const auto rim = [](const SeparatrixGraph& g) {
    const std::vector<double> lengths = graph::arc_lengths(g);
    double sum = 0;
    for (std::size_t a = 0; a < g.arcs.size(); ++a)
      if (g.arcs[a].is_boundary) sum += lengths[a];
    return sum;
  };
  EXPECT_NEAR(rim(simple), rim(graph), 1e-12);
  for (const GraphArc& arc : simple.arcs) {
    const ArcPiece &first = arc.pieces.front(), &last = arc.pieces.back();
    EXPECT_LT(distance(curve::point(simple.curve(first.curve), first.t0), simple.nodes[arc.from].position), 1e-12);
    EXPECT_LT(distance(curve::point(simple.curve(last.curve), last.t1), simple.nodes[arc.to].position), 1e-12);
  }
}

TEST_F(Hall, LinesLeadFromTheirOriginToTheirEnd) {
  const SeparatrixGraph simple = simplify(evaluator, graph, options, report);
  EXPECT_EQ(simple.lines.size(), 3u);
  for (const SeparatrixLine& line : simple.lines) {
    int at = line.origin;
    for (const int a : line.arcs) {
      const GraphArc& arc = simple.arcs[a];
      ASSERT_TRUE(arc.from == at || arc.to == at);
      at = arc.from == at ? arc.to : arc.from;
    }
    EXPECT_EQ(at, line.end);
  }
}

TEST_F(Hall, TheTurnIsBounded) {
  const double turn = turn_of_hall(step);
  options.max_turn = 0.99 * turn;
  EXPECT_EQ(graph::planar_faces(simplify(evaluator, graph, options, report)).cycles.size(), 6u);
  options.max_turn = 1.01 * turn;
  EXPECT_EQ(graph::planar_faces(simplify(evaluator, graph, options, report)).cycles.size(), 4u);
}

TEST_F(Hall, AHighStepIsLeft) {
  EXPECT_EQ(graph::planar_faces(simplify(evaluator, hall(0.8), options, report)).cycles.size(), 6u);
}

TEST_F(Hall, ABoundOfTheShapeStopsACollapse) {
  options.is_thrifty = false;
  options.least_scaled_jacobian = 0.999;
  EXPECT_EQ(graph::planar_faces(simplify(evaluator, graph, options, report)).cycles.size(), 6u);
}

TEST_F(Hall, BlendsAreFoundFromBothEnds) {
  const graph::ChordStrip strip = thin_strip();
  const auto blends = blends_of(evaluator, graph, strip, graph::pins_of(graph, strip), {1, 1e-9});
  ASSERT_TRUE(blends);
  ASSERT_EQ(blends->size(), 1u);
  const Blend& blend = blends->front();
  EXPECT_NEAR(blend.turn, turn_of_hall(step), 1e-3);
  const auto same = find_blend(*blends, blend.from, blend.to);
  const auto turned = find_blend(*blends, graph::reversed_pieces(blend.to), graph::reversed_pieces(blend.from));
  ASSERT_TRUE(same && turned);
  EXPECT_EQ(curve::point(*same, same->begin()), curve::point(*turned, turned->end()));
  EXPECT_FALSE(find_blend(*blends, blend.to, blend.from));
}

TEST(Simplify, StripsBetweenBoundariesStay) {
  const Field field = interpolated_field(square_mesh({-3, -3}, 6, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator evaluator(field);
  Report report;
  for (const SeparatrixGraph& graph :
       {hand_made::unit_square(), hand_made::l_shape(), hand_made::quarter_annulus(), hand_made::cut_annulus(4)}) {
    const graph::PlanarFaces faces = graph::planar_faces(graph);
    for (const graph::ChordStrip& strip : graph::all_strips(graph, faces, graph::arc_lengths(graph)))
      EXPECT_TRUE(graph::pins_of(graph, strip).empty());
    EXPECT_EQ(graph::planar_faces(simplify(evaluator, graph, {}, report)).cycles.size(), faces.cycles.size());
  }
}

TEST(Simplify, AnAnnulusHasOneClosedStrip) {
  const SeparatrixGraph graph = hand_made::cut_annulus(4);
  int closed = 0;
  for (const graph::ChordStrip& strip :
       graph::all_strips(graph, graph::planar_faces(graph), graph::arc_lengths(graph))) {
    closed += strip.is_closed;
    EXPECT_EQ(strip.rungs.size(), strip.blocks.size() + (strip.is_closed ? 0 : 1));
    EXPECT_FALSE(strip.crosses_itself);
  }
  EXPECT_EQ(closed, 1);
}

TEST(BlockShape, OfASquareAndOfASkewBlock) {
  const SeparatrixGraph square = hand_made::unit_square();
  const BlockShape shape = worst_shape(square, graph::planar_faces(square), {0});
  EXPECT_NEAR(shape.least_angle, half_pi, 1e-12);
  EXPECT_NEAR(shape.greatest_angle, half_pi, 1e-12);
  EXPECT_NEAR(shape.least_scaled_jacobian, 1, 1e-12);
  EXPECT_TRUE(shape.is_valid);
  const SeparatrixGraph skew =
      hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {2, 1}),
                                             curve::segment({2, 1}, {1, 1}), curve::segment({1, 1}, {0, 0})}},
                                           std::sqrt(5.0)),
                           {{0}, {1}, {2}, {3}});
  const BlockShape slanted = worst_shape(skew, graph::planar_faces(skew), {0});
  EXPECT_NEAR(slanted.least_angle, pi / 4, 1e-12);
  EXPECT_NEAR(slanted.greatest_angle, 3 * pi / 4, 1e-12);
  EXPECT_NEAR(slanted.least_scaled_jacobian, std::sqrt(0.5), 1e-12);
}

TEST(ChordPieces, AreJoinedWhereACurveGoesOnAndCutAgain) {
  const graph::Pieces whole = graph::joined({{3, 0, 1}}, {{3, 1, 2}, {4, 5, 4}});
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[0].t1, 2);
  const graph::Pieces back = graph::reversed_pieces(whole);
  EXPECT_EQ(back[0].curve, 4);
  EXPECT_EQ(back[0].t0, 4);
  EXPECT_EQ(graph::joined({{3, 0, 1}}, {{3, 1, 0}}).size(), 2u);  // there and back is not on
  const auto [before, behind] = graph::cut(whole, {{}, {}, 1, 4.5});
  ASSERT_EQ(before.size(), 2u);
  EXPECT_EQ(before[1].t1, 4.5);
  ASSERT_EQ(behind.size(), 1u);
  EXPECT_EQ(behind[0].t0, 4.5);
}

}  // namespace
}  // namespace quadrille::simplify
