#include "simplify/line_ends.hpp"

#include <gtest/gtest.h>

#include "../support/grid_layout.hpp"
#include "../support/square_field.hpp"
#include "graph/candidate_layout.hpp"
#include "simplify/block_quality.hpp"

namespace quadrille::simplify {
namespace {

// Four squares; the line from their common node down bends to (end, 0) instead of (1, 0).
SeparatrixGraph four_blocks(double end) {
  SeparatrixGraph g = grid_layout(2, 2);
  const int foot = 1, centre = 4;  // node numbers by row
  g.nodes[foot].position = {end, 0};
  g.nodes[foot].t = end;
  for (GraphArc& arc : g.arcs) {
    if (arc.is_boundary && arc.to == foot) arc.pieces = {{0, 0, end}};
    if (arc.is_boundary && arc.from == foot) arc.pieces = {{0, end, 2}};
    if (arc.is_boundary || arc.from != foot || arc.to != centre) continue;
    Nurbs& line = g.splines[arc.pieces[0].curve - g.face.num_curves()];
    line = end == 1 ? curve::segment({1, 0}, {1, 1})
                    : curve::cubic_spline({0, 0.6, 1.2}, {{end, 0}, {(1 + end) / 2, 0.3}, {1, 1}},
                                          normalized(Vec2{1 - end, 0.3}), {0, 1});
    arc.pieces[0].t0 = line.begin();
    arc.pieces[0].t1 = line.end();
  }
  return g;
}

struct EndOnFillets : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 2, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};

  static double quality(const graph::Subdivision& subdivision) {
    BlockQuads quads;
    return worst_quality(subdivision, all_faces(subdivision), quads).least_scaled_jacobian;
  }
};

TEST_F(EndOnFillets, TheEndMovesAlongTheBoundaryWhereBlocksBecomeBetter) {
  for (const double end : {0.4, 1.6}) {
    graph::CandidateLayout layout = graph::candidate_layout(four_blocks(end));
    const double before = quality(layout.subdivision);
    const FilletEnds ends = end_lines_on_fillets(evaluator, {{0, 1.0}}, layout);
    EXPECT_EQ(ends.num_moved, 1);
    EXPECT_GT(ends.deviation, 0);
    EXPECT_LT(ends.deviation, pi / 4);
    EXPECT_GT(quality(layout.subdivision), before + 0.1);
    EXPECT_EQ(layout.graph().nodes[1].position, (Vec2{1, 0}));
    EXPECT_EQ(layout.graph().nodes[1].t, 1.0);
    EXPECT_TRUE(graph::faces_without_four_corners(layout.subdivision).empty());
    EXPECT_EQ(layout.lines.back().kind, LineKind::merged);
    const graph::Subdivision built(layout.graph());
    for (int f = 0; f < built.face_bound(); ++f) EXPECT_EQ(layout.subdivision.cycle(f), built.cycle(f));
  }
}

TEST_F(EndOnFillets, NothingMovesWhereBlocksWouldBecomeWorse) {
  graph::CandidateLayout layout = graph::candidate_layout(four_blocks(1));
  EXPECT_EQ(end_lines_on_fillets(evaluator, {{0, 0.5}, {1, 0.2}}, layout).num_moved, 0);
  EXPECT_EQ(layout.graph().nodes[1].position, (Vec2{1, 0}));
  EXPECT_EQ(quality(layout.subdivision), quality(graph::Subdivision(four_blocks(1))));
}

TEST_F(EndOnFillets, AnEndThatIsOnTheFilletStays) {
  graph::CandidateLayout layout = graph::candidate_layout(four_blocks(0.4));
  EXPECT_EQ(end_lines_on_fillets(evaluator, {{0, 0.4}}, layout).num_moved, 0);
}

}  // namespace
}  // namespace quadrille::simplify
