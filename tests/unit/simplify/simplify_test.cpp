#include "simplify/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/hall.hpp"
#include "../support/square_field.hpp"
#include "base/angle.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::simplify {
namespace {

struct Hall : testing::Test {
  const double step = 0.1;
  const graph::CandidateLayout layout = hall(step);
  // The field need not end where the hall does.
  Field field = interpolated_field(square_mesh({-1, -2}, 6, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  SimplifyOptions options;
  Report report;

  SeparatrixGraph simplified() { return graph::separatrix_graph(simplify(evaluator, layout, options, report)); }
  int num_blocks() { return simplify(evaluator, layout, options, report).subdivision.num_faces(); }
};

TEST_F(Hall, TheStripBecomesOneLineBetweenTheReflexCorners) {
  const SeparatrixGraph simple = simplified();
  EXPECT_EQ(graph::require_four_corners(graph::Subdivision(simple)), 4);
  EXPECT_EQ(simple.nodes.size(), layout.graph().nodes.size() - 3);
  EXPECT_EQ(simple.splines.size(), 3u);
  const Nurbs* blend = nullptr;
  for (const SeparatrixLine& line : simple.lines)
    if (line.kind == LineKind::merged) {
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
  const SeparatrixGraph simple = simplified();
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
  const SeparatrixGraph simple = simplified();
  const auto rim = [](const ArcGraph& g) {
    const std::vector<double> lengths = graph::arc_lengths(g);
    double sum = 0;
    for (std::size_t a = 0; a < g.arcs.size(); ++a)
      if (g.arcs[a].is_boundary) sum += lengths[a];
    return sum;
  };
  EXPECT_NEAR(rim(simple), rim(layout.graph()), 1e-12);
  for (const GraphArc& arc : simple.arcs) {
    const ArcPiece &first = arc.pieces.front(), &last = arc.pieces.back();
    EXPECT_LT(distance(curve::point(simple.curve(first.curve), first.t0), simple.nodes[arc.from].position), 1e-12);
    EXPECT_LT(distance(curve::point(simple.curve(last.curve), last.t1), simple.nodes[arc.to].position), 1e-12);
  }
}

TEST_F(Hall, LinesLeadFromTheirOriginToTheirEnd) {
  const SeparatrixGraph simple = simplified();
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

TEST_F(Hall, TheDeviationIsBounded) {
  const double deviation = deviation_of_hall(step);
  options.max_deviation = 0.99 * deviation;
  EXPECT_EQ(num_blocks(), 6);
  options.max_deviation = 1.01 * deviation;
  EXPECT_EQ(num_blocks(), 4);
}

TEST_F(Hall, AHighStepIsLeft) { EXPECT_EQ(simplify(evaluator, hall(0.8), options, report).subdivision.num_faces(), 6); }

TEST_F(Hall, ABoundOfTheShapeStopsACollapse) {
  options.limits_loss_by_saving = false;
  options.least_scaled_jacobian = 0.999;
  EXPECT_EQ(num_blocks(), 6);
}

TEST_F(Hall, NothingIsBuiltFromScratch) {
  graph::CandidateLayout counted = layout;
  counted.num_built = 7;
  const graph::CandidateLayout simple = simplify(evaluator, std::move(counted), options, report);
  EXPECT_EQ(simple.subdivision.num_faces(), 4);
  EXPECT_EQ(simple.num_built, 7);
}

TEST_F(Hall, TheResultIsWhatItsGraphGives) {
  const graph::CandidateLayout simple = simplify(evaluator, layout, options, report);
  const graph::Subdivision built(simple.graph());
  ASSERT_EQ(simple.subdivision.face_bound(), built.face_bound());
  for (int f = 0; f < built.face_bound(); ++f) EXPECT_EQ(simple.subdivision.cycle(f), built.cycle(f));
}

TEST(Simplify, StripsBetweenBoundariesStay) {
  const Field field = interpolated_field(square_mesh({-3, -3}, 6, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator evaluator(field);
  Report report;
  for (const SeparatrixGraph& graph :
       {hand_made::unit_square(), hand_made::l_shape(), hand_made::quarter_annulus(), hand_made::cut_annulus(4)}) {
    const graph::CandidateLayout layout = graph::candidate_layout(graph);
    EXPECT_EQ(simplify(evaluator, layout, {}, report).subdivision.num_faces(), layout.subdivision.num_faces());
  }
}

}  // namespace
}  // namespace quadrille::simplify
