#include "quantize/extend_lines.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "graph/build_graph.hpp"
#include "graph/face_census.hpp"
#include "graph/planar_faces.hpp"
#include "layout/certificate.hpp"

namespace quadrille::quantize {
namespace {

using hand_made::face;

CadFace square() {
  return face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}), curve::segment({1, 1}, {0, 1}),
                curve::segment({0, 1}, {0, 0})}},
              std::sqrt(2.0));
}

/// A straight line from one place of the boundary to another, or to a crossing with another line.
struct Line {
  Vec2 from, to;
  int curve0 = 0, curve1 = -1;  // -1: ends on a line
};

SeparatrixGraph t_mesh(const std::vector<Line>& lines) {
  const CadFace f = square();
  std::vector<graph::FixedNode> corners;
  for (int j = 0; j < 4; ++j) corners.push_back({f.joints[j].position, NodeKind::corner, 1, j});
  const auto parameter = [&](int curve, Vec2 x) { return distance(x, f.joints[curve].position); };
  std::vector<graph::FinishedLine> finished;
  std::vector<Nurbs> splines;
  for (const Line& l : lines) {
    const double length = distance(l.from, l.to);
    const Vec2 along = (l.to - l.from) / length;
    const graph::LineEnd end =
        l.curve1 >= 0 ? graph::LineEnd{-1, l.curve1, parameter(l.curve1, l.to)} : graph::LineEnd{};
    finished.push_back({{-1, l.curve0, parameter(l.curve0, l.from)},
                        end,
                        curve::cubic_spline({0, length / 2, length}, {l.from, (l.from + l.to) / 2, l.to}, along, along),
                        "traced"});
    splines.push_back(finished.back().spline);
  }
  return graph::build_graph(f, corners, finished, graph::find_crossings(splines, 1e-9), 1e-9);
}

int num_t_junctions(const SeparatrixGraph& graph) { return static_cast<int>(graph.t_junctions.size()); }

bool has_node(const SeparatrixGraph& graph, Vec2 x) {
  for (const GraphNode& node : graph.nodes)
    if (distance(node.position, x) < 1e-9) return true;
  return false;
}

const std::vector<Line> one_t{{{0.3, 0}, {0.3, 1}, 0, 2}, {{1, 0.4}, {0.3, 0.4}, 1, -1}};

// Next to a node lines turn fast: the angle at which one stops at another, here 36 degrees, says nothing.
TEST(TMesh, ATJunctionIsWhatItIsAtAnyAngle) {
  for (const double y : {0.02, 0.5, 0.98}) {
    const SeparatrixGraph graph = t_mesh({{{0.3, 0}, {0.3, 1}, 0, 2}, {{1, y}, {0.3, 1 - y}, 1, -1}});
    EXPECT_EQ(num_t_junctions(graph), 1);
    EXPECT_EQ(t_mesh_faces(graph).size(), 3u) << y;
  }
}

TEST(TMesh, ALineThatEndsOnAnotherMakesATJunctionAndFourCorneredFaces) {
  const SeparatrixGraph graph = t_mesh(one_t);
  EXPECT_EQ(num_t_junctions(graph), 1);
  const std::vector<TFace> faces = t_mesh_faces(graph);
  ASSERT_EQ(faces.size(), 3u);
  size_t half_edges = 0;
  for (const TFace& f : faces)
    for (const auto& side : f) half_edges += side.size();
  EXPECT_EQ(half_edges, 13u);  // four sides each, and one more where the T-junction is
  const std::vector<FaceCount> census = graph::face_census(graph);
  ASSERT_EQ(census.size(), 1u);
  EXPECT_EQ(census[0].corners, 4);
  EXPECT_EQ(census[0].faces, 3);
}

TEST(ExtendLines, TheStoppedLineGoesStraightOnToTheBoundary) {
  const SeparatrixGraph graph = t_mesh(one_t);
  const std::vector<TFace> faces = t_mesh_faces(graph);
  std::vector<int> lengths(graph.arcs.size(), 1);
  // The left side of the square has no node yet: two units there, as on the line with the T-junction.
  for (const TFace& f : faces)
    for (int k = 0; k < 4; ++k)
      if (f[k].size() == 2) lengths[f[(k + 2) % 4].front().arc] = 2;
  const SeparatrixGraph whole = extend_lines(graph, faces, lengths);
  EXPECT_EQ(num_t_junctions(whole), 0);
  EXPECT_EQ(graph::require_four_corners(whole), 4);
  EXPECT_TRUE(has_node(whole, {0, 0.4}));
  EXPECT_EQ(whole.lines.back().kind, "extended");
}

// Four lines, each stopped by the next one, around a block in the middle.
const std::vector<Line> pinwheel{{{0.4, 0}, {0.4, 0.7}, 0, -1},
                                 {{0, 0.7}, {0.6, 0.7}, 3, -1},
                                 {{0.6, 1}, {0.6, 0.3}, 2, -1},
                                 {{1, 0.3}, {0.4, 0.3}, 1, -1}};

SeparatrixGraph extended_pinwheel(int in_the_middle) {
  const SeparatrixGraph graph = t_mesh(pinwheel);
  const std::vector<TFace> faces = t_mesh_faces(graph);
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
  SeparatrixGraph whole = extend_lines(graph, faces, lengths);
  return whole;
}

TEST(ExtendLines, APinwheelBecomesNineBlocksWhateverTheLengths) {
  for (const int middle : {1, 2, 5}) {
    const SeparatrixGraph whole = extended_pinwheel(middle);
    EXPECT_EQ(num_t_junctions(whole), 0);
    EXPECT_EQ(graph::require_four_corners(whole), 9);
  }
}

TEST(ExtendLines, FacesOfOtherShapesAreNamed) {
  // The same graph, taken to have a corner of two quarters.
  SeparatrixGraph graph = t_mesh(one_t);
  graph.nodes[0].valence = 2;
  EXPECT_THROW(t_mesh_faces(graph), ComputeError);
}

}  // namespace
}  // namespace quadrille::quantize
