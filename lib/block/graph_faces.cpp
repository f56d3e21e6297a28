#include "block/graph_faces.hpp"

#include <algorithm>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille {
namespace {

/// The twin of directed arc a is -1 - a; [2 arc] forwards and [2 arc + 1] backwards index tables.
int twin(int directed) { return -1 - directed; }
int slot(int directed) { return directed >= 0 ? 2 * directed : 2 * (-1 - directed) + 1; }

double start_angle(const SeparatrixGraph& graph, int directed) {
  const GraphArc& arc = graph.arcs[directed >= 0 ? directed : twin(directed)];
  const ArcPiece& piece = directed >= 0 ? arc.pieces.front() : arc.pieces.back();
  const double t = directed >= 0 ? piece.t0 : piece.t1;
  const bool rising = (piece.t0 < piece.t1) == (directed >= 0);
  const Vec2 along = tangent(graph.curve(piece.curve), t, !rising);
  return angle_of(rising ? along : -along);
}

/// For each directed arc the next one around the face on its left: the first clockwise from its twin.
std::vector<int> next_in_face(const SeparatrixGraph& graph) {
  struct Spoke {
    double angle;
    int directed;
  };
  std::vector<std::vector<Spoke>> spokes(graph.nodes.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    spokes[graph.arcs[a].from].push_back({start_angle(graph, a), a});
    spokes[graph.arcs[a].to].push_back({start_angle(graph, twin(a)), twin(a)});
  }
  std::vector<int> next(2 * graph.arcs.size());
  for (std::vector<Spoke>& around : spokes) {
    std::sort(around.begin(), around.end(), [](const Spoke& a, const Spoke& b) { return a.angle < b.angle; });
    for (std::size_t k = 0; k < around.size(); ++k)
      next[slot(twin(around[(k + 1) % around.size()].directed))] = around[k].directed;
  }
  return next;
}

}  // namespace

std::vector<std::vector<int>> graph_faces(const SeparatrixGraph& graph) {
  const std::vector<int> next = next_in_face(graph);
  std::vector<bool> seen(next.size(), false);
  std::vector<std::vector<int>> faces;
  for (int arc = 0; arc < static_cast<int>(graph.arcs.size()); ++arc)
    for (const int first : {arc, twin(arc)}) {
      if (seen[slot(first)]) continue;
      std::vector<int> face;
      bool is_outside = false;
      for (int d = first; !seen[slot(d)]; d = next[slot(d)]) {
        seen[slot(d)] = true;
        face.push_back(d);
        is_outside |= d < 0 && graph.arcs[twin(d)].is_boundary;
      }
      if (!is_outside) faces.push_back(std::move(face));
    }
  return faces;
}

}  // namespace quadrille
