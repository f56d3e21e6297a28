#include "quantize/quantize_and_extend.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_made.hpp"
#include "../support/square_t_mesh.hpp"
#include "base/error.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::quantize {
namespace {

// The unit square. Arc 0 is its floor and its right side, arc 1 the rest, arc 2 a line from (0, 0) to (1, 1).
struct SplitSquare : testing::Test {
  SeparatrixGraph graph = hand_made::unit_square();
  ArcGraph whole;  ///< with split arcs
  ArcParts parts;

  void make(const CrossingFractions& fractions) {
    graph.arcs.clear();
    graph.nodes = {graph.nodes[0], graph.nodes[2]};
    for (GraphNode& node : graph.nodes) node.valence = 2;
    hand_made::add_arc(graph, 0, 1, true, {{0, 0, 1}, {1, 0, 1}});
    hand_made::add_arc(graph, 1, 0, true, {{2, 0, 1}, {3, 0, 1}});
    hand_made::add_cut(graph, 0, 1);
    const curve::CurveTable table(graph.face, graph.splines);
    std::vector<curve::Chain> chains;
    for (const GraphArc& arc : graph.arcs) chains.emplace_back(table, arc.pieces);
    graph::Subdivision subdivision(graph);
    parts = split_arcs(chains, fractions, subdivision);
    whole = subdivision.graph();
  }
  const GraphArc& part(int arc, int k) const { return whole.arcs[parts[arc][k]]; }

  static void expect_piece(const ArcPiece& piece, int curve, double t0, double t1) {
    EXPECT_EQ(piece.curve, curve);
    EXPECT_NEAR(piece.t0, t0, 1e-12);
    EXPECT_NEAR(piece.t1, t1, 1e-12);
  }
};

TEST_F(SplitSquare, WithoutCrossingsEveryArcIsOnePart) {
  make({{}, {}, {}});
  ASSERT_EQ(whole.arcs.size(), 3u);
  EXPECT_EQ(whole.nodes.size(), 2u);
  for (int a = 0; a < 3; ++a) {
    ASSERT_EQ(parts[a].size(), 1u);
    EXPECT_EQ(part(a, 0).from, graph.arcs[a].from);
    EXPECT_EQ(part(a, 0).to, graph.arcs[a].to);
    EXPECT_EQ(part(a, 0).is_boundary, a < 2);
    EXPECT_EQ(part(a, 0).pieces.size(), graph.arcs[a].pieces.size());
  }
}

TEST_F(SplitSquare, ABoundaryArcIsCutInsideItsPieces) {
  make({{{1, 0.25}, {4, 0.75}}, {}, {}});
  ASSERT_EQ(parts[0].size(), 3u);
  expect_piece(part(0, 0).pieces.at(0), 0, 0, 0.5);
  ASSERT_EQ(part(0, 1).pieces.size(), 2u);
  expect_piece(part(0, 1).pieces[0], 0, 0.5, 1);
  expect_piece(part(0, 1).pieces[1], 1, 0, 0.5);
  ASSERT_EQ(part(0, 2).pieces.size(), 1u);
  expect_piece(part(0, 2).pieces[0], 1, 0.5, 1);
  const int second = part(0, 1).to;
  EXPECT_EQ(part(0, 1).from, part(0, 0).to);
  EXPECT_EQ(part(0, 2).from, second);
  EXPECT_EQ(part(0, 0).from, 0);
  EXPECT_EQ(part(0, 2).to, 1);
  const GraphNode& node = whole.nodes[second];
  EXPECT_EQ(node.kind, NodeKind::boundary);
  EXPECT_EQ(node.valence, 2);
  EXPECT_EQ(node.curve, 1);
  EXPECT_NEAR(distance(node.position, {1, 0.5}), 0, 1e-12);
}

TEST_F(SplitSquare, TwoCrossingsMayLieOnOnePiece) {
  make({{{1, 0.1}, {2, 0.2}}, {}, {}});
  ASSERT_EQ(parts[0].size(), 3u);
  ASSERT_EQ(part(0, 1).pieces.size(), 1u);
  expect_piece(part(0, 1).pieces[0], 0, 0.2, 0.4);
  EXPECT_EQ(part(0, 2).pieces.size(), 2u);
}

TEST_F(SplitSquare, ACutAtAJointLeavesNoPieceOfNoLength) {
  make({{{1, 0.5}}, {}, {}});
  ASSERT_EQ(parts[0].size(), 2u);
  for (const int k : {0, 1}) {
    ASSERT_EQ(part(0, k).pieces.size(), 1u);
    expect_piece(part(0, k).pieces[0], k, 0, 1);
  }
}

TEST_F(SplitSquare, ALineInsideGetsRegularNodes) {
  make({{}, {}, {{2, 0.5}}});
  ASSERT_EQ(parts[2].size(), 2u);
  const GraphNode& node = whole.nodes[part(2, 0).to];
  EXPECT_EQ(node.kind, NodeKind::crossing);
  EXPECT_EQ(node.valence, 4);
  EXPECT_EQ(node.curve, -1);
  EXPECT_NEAR(distance(node.position, {0.5, 0.5}), 0, 1e-12);
}

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

using square_t_mesh::Line;
using square_t_mesh::one_t;

int num_t_junctions(const graph::CandidateLayout& layout) { return static_cast<int>(layout.t_junctions.size()); }

bool has_node(const ArcGraph& graph, Vec2 x) {
  for (const GraphNode& node : graph.nodes)
    if (distance(node.position, x) < 1e-9) return true;
  return false;
}

TEST(ExtendLines, TheStoppedLineGoesStraightOnToTheBoundary) {
  const SeparatrixGraph graph = square_t_mesh::make(one_t);
  const graph::CandidateLayout layout = graph::candidate_layout(graph);
  const std::vector<TFace> faces = t_mesh_faces(layout.subdivision);
  const graph::CandidateLayout whole = extend_lines(layout, faces, square_t_mesh::lengths_of_one_t(graph, faces));
  EXPECT_EQ(num_t_junctions(whole), 0);
  EXPECT_EQ(whole.num_built, layout.num_built) << "updated locally";
  EXPECT_EQ(graph::require_four_corners(whole.subdivision), 4);
  EXPECT_TRUE(has_node(whole.graph(), {0, 0.4}));
  EXPECT_EQ(whole.lines.back().kind, LineKind::extended);
}

// Four lines, each stopped by the next one, around a block in the middle.
const std::vector<Line> pinwheel{{{0.4, 0}, {0.4, 0.7}, 0, -1},
                                 {{0, 0.7}, {0.6, 0.7}, 3, -1},
                                 {{0.6, 1}, {0.6, 0.3}, 2, -1},
                                 {{1, 0.3}, {0.4, 0.3}, 1, -1}};

graph::CandidateLayout extended_pinwheel(int in_the_middle) {
  const graph::CandidateLayout layout = graph::candidate_layout(square_t_mesh::make(pinwheel));
  const ArcGraph& graph = layout.graph();
  const std::vector<TFace> faces = t_mesh_faces(layout.subdivision);
  EXPECT_EQ(faces.size(), 5u);
  std::vector<int> lengths(graph.arcs.size(), 0);
  // Arcs around the middle block, other inner arcs, and the boundary arcs opposite to both.
  for (const TFace& f : faces) {
    const bool is_middle = std::all_of(f.begin(), f.end(), [&](const std::vector<HalfEdge>& side) {
      return side.size() == 1 && !graph.arcs[side.front().arc].is_boundary;
    });
    if (!is_middle) continue;
    for (const auto& side : f) lengths[side.front().arc] = in_the_middle;
  }
  for (size_t a = 0; a < graph.arcs.size(); ++a)
    if (lengths[a] == 0 && !graph.arcs[a].is_boundary) lengths[a] = 1;
  for (const TFace& f : faces)
    for (int k = 0; k < 4; ++k) {
      const int across = (k + 2) % 4;
      int total = 0;
      for (const HalfEdge h : f[across]) total += lengths[h.arc];
      if (f[k].size() == 1 && graph.arcs[f[k].front().arc].is_boundary) lengths[f[k].front().arc] = total;
    }
  return extend_lines(layout, faces, lengths);
}

TEST(ExtendLines, APinwheelBecomesNineBlocksWhateverTheLengths) {
  for (const int middle : {1, 2, 5}) {
    const graph::CandidateLayout whole = extended_pinwheel(middle);
    EXPECT_EQ(num_t_junctions(whole), 0);
    EXPECT_EQ(graph::require_four_corners(whole.subdivision), 9);
  }
}

graph::CandidateLayout never(const InfeasibleTMesh&) { throw ComputeError("no lengths"); }

/// Divides a side of the square at a parameter.
void divide(graph::CandidateLayout& layout, int curve, double t) {
  const ArcGraph& graph = layout.graph();
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    const ArcPiece& piece = graph.arcs[a].pieces.front();
    if (piece.curve != curve || t <= piece.t0 || t >= piece.t1) continue;
    const Nurbs& side = graph.face.curves[curve];
    graph::divide_at_point(layout.subdivision, {a}, {curve::point(side, t), curve::tangent(side, t), 0, t});
    return;
  }
}

/// A line across the square, whose left and right sides are periodic, from one height to another, with the images of
/// its ends.
graph::CandidateLayout slanted(double left, double right) {
  SeparatrixGraph graph = square_t_mesh::make({{{0, left}, {1, right}, 3, 1}});
  graph.face.periodic_pairs = {{{3, 1}, 0, {1, 0}}};
  graph::CandidateLayout layout = graph::candidate_layout(std::move(graph));
  if (left == right) return layout;
  divide(layout, 1, left);
  divide(layout, 3, 1 - right);
  return layout;
}

TEST(QuantizeAndExtend, ALineContinuesToTheBoundary) {
  const graph::CandidateLayout t_mesh = graph::candidate_layout(square_t_mesh::make(square_t_mesh::one_t));
  const ExtendedTMesh extended = quantize_and_extend(t_mesh, PeriodicSides::separate, never, nullptr);
  EXPECT_TRUE(extended.layout.t_junctions.empty());
  EXPECT_EQ(graph::require_four_corners(extended.layout.subdivision), 4);
  EXPECT_EQ(extended.longest_arc, 7) << "a tenth of the diameter is one: a side is 1 / 0.1414 long";
}

TEST(QuantizeAndExtend, ATMeshWithoutLengthsIsReplaced) {
  int num_replaced = 0;
  const auto replace = [&](const InfeasibleTMesh& failed) {
    ++num_replaced;
    EXPECT_FALSE(failed.strips.empty());
    EXPECT_FALSE(failed.zero_arcs().empty());
    EXPECT_EQ(failed.t_mesh.graph().nodes.size(), 8U);
    return slanted(0.5, 0.5);
  };
  const ExtendedTMesh extended = quantize_and_extend(slanted(0.2, 0.8), PeriodicSides::glued, replace, nullptr);
  EXPECT_EQ(num_replaced, 1);
  EXPECT_EQ(graph::require_four_corners(extended.layout.subdivision), 2);
}

TEST(QuantizeAndExtend, SeparateSidesAreBoundariesLikeOthers) {
  const ExtendedTMesh extended = quantize_and_extend(slanted(0.2, 0.8), PeriodicSides::separate, never, nullptr);
  EXPECT_TRUE(extended.layout.t_junctions.empty());
}

}  // namespace
}  // namespace quadrille::quantize
