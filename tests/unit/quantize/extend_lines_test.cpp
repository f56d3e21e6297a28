#include "quantize/extend_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/square_t_mesh.hpp"
#include "graph/face_corners.hpp"

namespace quadrille::quantize {
namespace {

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

}  // namespace
}  // namespace quadrille::quantize
