#include "graph/candidate_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "graph/subdivision.hpp"
#include "model/interfaces.hpp"
#include "surface/positions.hpp"

namespace quadrille::graph {

std::vector<LineKind> spline_kinds(const ArcGraph& graph, const std::vector<SeparatrixLine>& lines) {
  std::vector<LineKind> kinds(graph.splines.size(), LineKind::traced);
  for (const SeparatrixLine& line : lines)
    for (const int arc : line.arcs)
      for (const ArcPiece& p : graph.arcs[arc].pieces) kinds[p.curve - graph.face.num_curves()] = line.kind;
  return kinds;
}

std::vector<SeparatrixLine> lines_of_arcs(const ArcGraph& graph, const std::vector<LineKind>& kinds) {
  std::vector<std::vector<int>> arcs_of(graph.splines.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    if (!is_on_cad_curve(graph, graph.arcs[a]))
      arcs_of[graph.arcs[a].pieces.front().curve - graph.face.num_curves()].push_back(a);
  const auto low = [&](int a) { return std::min(graph.arcs[a].pieces.front().t0, graph.arcs[a].pieces.back().t1); };
  std::vector<SeparatrixLine> lines;
  for (std::size_t i = 0; i < arcs_of.size(); ++i) {
    std::sort(arcs_of[i].begin(), arcs_of[i].end(), [&](int a, int b) { return low(a) < low(b); });
    for (const int a : arcs_of[i]) {
      const GraphArc& arc = graph.arcs[a];
      const bool rises = arc.pieces.front().t0 < arc.pieces.front().t1;
      const int from = rises ? arc.from : arc.to, to = rises ? arc.to : arc.from;
      if (a == arcs_of[i].front() || lines.back().end != from) lines.push_back({from, from, kinds[i], {}});
      lines.back().end = to;
      lines.back().arcs.push_back(a);
    }
  }
  return lines;
}

void rebuild_lines(CandidateLayout& layout, std::vector<LineKind> kinds, LineKind added) {
  kinds.resize(layout.graph().splines.size(), added);
  layout.lines = lines_of_arcs(layout.graph(), kinds);
  layout.subdivision.drop_unused_splines();
}

Vec2 middle_of_face(const Subdivision& subdivision, int face) {
  const ArcGraph& graph = subdivision.graph();
  const std::vector<HalfEdge> cycle = subdivision.cycle(face);
  Vec2 sum;
  for (const HalfEdge h : cycle) {
    const auto& pieces = graph.arcs[h.arc].pieces;
    const ArcPiece& piece = pieces[pieces.size() / 2];
    sum += curve::point(graph.curve(piece.curve), (piece.t0 + piece.t1) / 2);
  }
  return sum / static_cast<double>(cycle.size());
}

std::vector<int> faces_without_four_corners(const Subdivision& subdivision) {
  std::vector<int> bad;
  for (int f = 0; f < subdivision.face_bound(); ++f) {
    const std::size_t num_sides = subdivision.cycle(f).size();
    if (num_sides > 0 && (num_sides != 4 || subdivision.num_corners(f) != 4)) bad.push_back(f);
  }
  return bad;
}

int require_four_corners(const Subdivision& subdivision) {
  const int num_faces = subdivision.num_faces();
  const std::vector<int> bad = faces_without_four_corners(subdivision);
  if (!bad.empty()) {
    throw ComputeError(
        fmt::format("{} of {} faces of the separatrix graph {} not four corners; the one around {} has {}", bad.size(),
                    num_faces, bad.size() == 1 ? "has" : "have",
                    surface::position_text(subdivision.graph().face, middle_of_face(subdivision, bad.front())),
                    subdivision.num_corners(bad.front())));
  }
  // Regions with an open interface between them need not be connected.
  if (subdivision.num_components() > subdivision.graph().face.num_regions())
    throw ComputeError(fmt::format("the separatrix graph has {} unconnected parts: one of its faces has a hole",
                                   subdivision.num_components()));
  return num_faces;
}

bool is_drawn_in_order(const Subdivision& subdivision, int node) {
  std::vector<HalfEdge> order = subdivision.around(node), sorted = order;
  sort_around_node(subdivision.graph(), sorted);
  std::rotate(order.begin(), std::find(order.begin(), order.end(), sorted.front()), order.end());
  return order == sorted;
}

void require_drawn_in_order(const Subdivision& subdivision) {
  for (int n = 0; n < subdivision.node_bound(); ++n)
    if (!subdivision.around(n).empty() && !is_drawn_in_order(subdivision, n))
      throw ComputeError(
          fmt::format("lines of the separatrix graph at {} run across each other",
                      surface::position_text(subdivision.graph().face, subdivision.graph().nodes[n].position)));
}

std::vector<FaceCount> face_valence_histogram(const Subdivision& subdivision) {
  std::map<int, int> corners2faces;
  for (int f = 0; f < subdivision.face_bound(); ++f)
    if (!subdivision.cycle(f).empty()) ++corners2faces[subdivision.num_corners(f)];
  std::vector<FaceCount> histogram;
  for (const auto& [corners, faces] : corners2faces) histogram.push_back({corners, faces});
  return histogram;
}

}  // namespace quadrille::graph
