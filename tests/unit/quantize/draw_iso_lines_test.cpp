#include "quantize/draw_iso_lines.hpp"

#include <gtest/gtest.h>

#include "../support/square_t_mesh.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::quantize {
namespace {

using square_t_mesh::Line;

/// The T-mesh of some lines in the square, with the iso-lines of all faces drawn.
struct Drawn {
  SeparatrixGraph t_mesh;
  ArcGraph graph;
  std::vector<SeparatrixLine> lines;  ///< those that were drawn

  explicit Drawn(const std::vector<Line>& stopped) : t_mesh(square_t_mesh::make(stopped)) {
    const std::vector<TFace> faces = t_mesh_faces(graph::Subdivision(t_mesh));
    const std::vector<int> lengths = square_t_mesh::lengths_of_one_t(t_mesh, faces);
    const curve::CurveTable table(t_mesh.face, t_mesh.splines);
    std::vector<curve::Chain> chains;
    std::vector<double> arc_lengths;
    for (const GraphArc& arc : t_mesh.arcs) chains.emplace_back(table, arc.pieces);
    for (const curve::Chain& chain : chains) arc_lengths.push_back(chain.length());
    const QuantizedParametrization parametrization(t_mesh, faces, lengths, arc_lengths);
    graph::CandidateLayout layout = graph::candidate_layout(t_mesh);
    layout.lines.clear();
    const ArcParts parts = split_arcs(chains, parametrization.crossing_fractions(), layout.subdivision);
    num_split = layout.subdivision.arc_bound();
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      draw_iso_lines({t_mesh, table, parametrization, parts}, f, layout);
    graph = layout.graph();
    lines = layout.lines;
  }
  int num_split = 0;  ///< arcs before lines were drawn

  Vec2 at(int node) const { return graph.nodes[node].position; }
  /// The drawn line between these points, in either direction.
  const SeparatrixLine* line_between(Vec2 a, Vec2 b) const {
    for (const SeparatrixLine& line : lines)
      if (std::min(distance(at(line.origin), a) + distance(at(line.end), b),
                   distance(at(line.origin), b) + distance(at(line.end), a)) < 1e-9)
        return &line;
    return nullptr;
  }
};

TEST(DrawIsoLines, AFaceWithoutLinesStaysAsItIs) {
  const Drawn drawn({{{0.3, 0}, {0.3, 1}, 0, 2}});
  EXPECT_TRUE(drawn.lines.empty());
  EXPECT_EQ(drawn.graph.arcs.size(), drawn.t_mesh.arcs.size());
  EXPECT_EQ(drawn.graph.splines.size(), 1u);
}

TEST(DrawIsoLines, AStoppedLineIsExtendedStraightToTheOppositeSide) {
  const Drawn drawn(square_t_mesh::one_t);
  ASSERT_EQ(drawn.lines.size(), 1u);
  const SeparatrixLine* line = drawn.line_between({0.3, 0.4}, {0, 0.4});
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->kind, LineKind::extended);
  ASSERT_EQ(line->arcs.size(), 1u);
  const ArcPiece& piece = drawn.graph.arcs[line->arcs[0]].pieces.at(0);
  const Nurbs& curve = drawn.graph.curve(piece.curve);
  for (int i = 0; i <= 8; ++i) EXPECT_NEAR(curve::point(curve, piece.t0 + (piece.t1 - piece.t0) * i / 8).y, 0.4, 1e-9);
}

// A face with T-junctions on its right side and on its top.
const std::vector<Line> crossing_lines{{{0.6, 0}, {0.6, 1}, 0, 2},
                                       {{1, 0.3}, {0.6, 0.3}, 1, -1},
                                       {{0, 0.8}, {0.6, 0.8}, 3, -1},
                                       {{0.2, 1}, {0.2, 0.8}, 2, -1}};

TEST(DrawIsoLines, LinesOfBothDirectionsShareANodeWhereTheyCross) {
  const Drawn drawn(crossing_lines);
  ASSERT_EQ(drawn.lines.size(), 3u);
  const SeparatrixLine *along = drawn.line_between({0.6, 0.3}, {0, 0.3}),
                       *up = drawn.line_between({0.2, 0.8}, {0.2, 0});
  ASSERT_TRUE(along && up);
  EXPECT_NE(drawn.line_between({0.6, 0.8}, {1, 0.8}), nullptr);
  ASSERT_EQ(along->arcs.size(), 2u);
  ASSERT_EQ(up->arcs.size(), 2u);
  const int node = drawn.graph.arcs[along->arcs[0]].to;
  EXPECT_EQ(drawn.graph.arcs[along->arcs[1]].from, node);
  EXPECT_EQ(drawn.graph.arcs[up->arcs[0]].to, node);
  EXPECT_EQ(drawn.graph.nodes[node].kind, NodeKind::crossing);
  EXPECT_NEAR(distance(drawn.at(node), {0.2, 0.3}), 0, 1e-9);
}

TEST(DrawIsoLines, ArcsLieOnTheSplinesOfTheirLines) {
  const Drawn drawn(crossing_lines);
  for (std::size_t a = drawn.num_split; a < drawn.graph.arcs.size(); ++a) {
    const GraphArc& arc = drawn.graph.arcs[a];
    ASSERT_EQ(arc.pieces.size(), 1u);
    const Nurbs& curve = drawn.graph.curve(arc.pieces[0].curve);
    EXPECT_NEAR(distance(curve::point(curve, arc.pieces[0].t0), drawn.at(arc.from)), 0, 1e-12);
    EXPECT_NEAR(distance(curve::point(curve, arc.pieces[0].t1), drawn.at(arc.to)), 0, 1e-12);
    EXPECT_FALSE(arc.is_boundary);
  }
  EXPECT_EQ(static_cast<int>(drawn.graph.arcs.size()), drawn.num_split + 5);
}

}  // namespace
}  // namespace quadrille::quantize
