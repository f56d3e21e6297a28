#pragma once
// T-meshes of straight lines in the unit square.

#include <cmath>
#include <vector>

#include "../hand_made.hpp"
#include "curve/nurbs.hpp"
#include "graph/build_graph.hpp"
#include "quantize/quantize.hpp"

namespace quadrille::square_t_mesh {

inline CadFace square() {
  return hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}),
                           curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                         std::sqrt(2.0));
}

/// A straight line from one point of the boundary to another, or to a crossing with another line.
struct Line {
  Vec2 from, to;
  int curve0 = 0, curve1 = -1;  // -1: ends on a line
};

inline SeparatrixGraph make(const std::vector<Line>& lines) {
  const CadFace f = square();
  std::vector<GraphNode> corners;
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
                        LineKind::traced});
    splines.push_back(finished.back().spline);
  }
  return graph::build_graph(f, corners, finished, graph::find_crossings(splines, 1e-9), 1e-9);
}

/// A line across the square at x = 0.3, and one from the right side at y = 0.4 that stops there.
inline const std::vector<Line> one_t{{{0.3, 0}, {0.3, 1}, 0, 2}, {{1, 0.4}, {0.3, 0.4}, 1, -1}};

/// All arcs have length one, but for the left side of the square, which has no node yet: two, as the line with the
/// T-junction opposite to it.
inline std::vector<int> lengths_of_one_t(const SeparatrixGraph& graph, const std::vector<quantize::TFace>& faces) {
  std::vector<int> lengths(graph.arcs.size(), 1);
  for (const quantize::TFace& f : faces)
    for (int k = 0; k < 4; ++k)
      if (f[k].size() == 2) lengths[f[(k + 2) % 4].front().arc] = 2;
  return lengths;
}

}  // namespace quadrille::square_t_mesh
