#include "graph/arc_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "model/interfaces.hpp"

namespace quadrille::graph {
namespace {

// The parameter of a joint belongs to the piece behind it.
curve::ChainPoint moved_to_joint(const Pieces& pieces, curve::ChainPoint at) {
  const ArcPiece& piece = pieces[at.piece];
  const double same = tolerance::round_off * std::abs(piece.t1 - piece.t0);
  if (std::abs(at.t - piece.t1) <= same && at.piece + 1 < static_cast<int>(pieces.size())) {
    at.t = pieces[++at.piece].t0;
  } else if (std::abs(at.t - piece.t0) <= same && at.piece > 0) {
    at.t = piece.t0;
  }
  return at;
}

}  // namespace

Pieces reversed_pieces(Pieces pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (ArcPiece& p : pieces) std::swap(p.t0, p.t1);
  return pieces;
}

Pieces pieces_along(const ArcGraph& graph, HalfEdge h) {
  const Pieces& pieces = graph.arcs[h.arc].pieces;
  return h.is_backwards ? reversed_pieces(pieces) : pieces;
}

Pieces boundary_path(const CadFace& face, const GraphNode& from, const GraphNode& to) {
  Pieces pieces;
  int curve = from.curve;
  double t = from.t;
  while (curve != to.curve || (t >= to.t && pieces.empty())) {
    pieces.push_back({curve, t, face.curves[curve].end()});
    curve = face.next_in_loop(curve);
    t = face.curves[curve].begin();
  }
  if (t < to.t) pieces.push_back({curve, t, to.t});
  return pieces;
}

curve::ChainPoint point_on_piece(const ArcGraph& graph, const Pieces& pieces, std::size_t piece, double t) {
  const Nurbs& curve = graph.curve(pieces[piece].curve);
  const Vec2 along = curve::tangent(curve, t);
  return {curve::point(curve, t), pieces[piece].t0 < pieces[piece].t1 ? along : -along, static_cast<int>(piece), t};
}

Pieces joined(Pieces first, const Pieces& second) {
  for (const ArcPiece& p : second) {
    if (!first.empty()) {
      ArcPiece& last = first.back();
      const bool goes_on = last.curve == p.curve && (last.t1 > last.t0) == (p.t1 > p.t0) &&
                           std::abs(last.t1 - p.t0) <= tolerance::round_off * std::abs(p.t1 - p.t0);
      if (goes_on) {
        last.t1 = p.t1;
        continue;
      }
    }
    first.push_back(p);
  }
  return first;
}

std::pair<Pieces, Pieces> cut(const Pieces& pieces, const curve::ChainPoint& at) {
  Pieces before(pieces.begin(), pieces.begin() + at.piece + 1), behind(pieces.begin() + at.piece, pieces.end());
  before.back().t1 = at.t;
  behind.front().t0 = at.t;
  if (before.size() > 1 && before.back().t0 == at.t) before.pop_back();
  if (behind.size() > 1 && behind.front().t1 == at.t) behind.erase(behind.begin());
  return {before, behind};
}

Subdivision::Division divide_at_point(Subdivision& subdivision, HalfEdge h, const curve::ChainPoint& at) {
  const Pieces pieces = pieces_along(subdivision.graph(), h);
  const curve::ChainPoint point = moved_to_joint(pieces, at);
  auto [before, behind] = cut(pieces, point);
  const ArcGraph& graph = subdivision.graph();
  const GraphArc& arc = graph.arcs[h.arc];
  const ArcPiece& next = behind.front();
  const GraphNode node = arc.is_boundary ? GraphNode{at.position, NodeKind::boundary, 2, next.curve, next.t0}
                         : is_on_interface(graph, arc)
                             ? GraphNode{at.position, NodeKind::interface, 4, next.curve, next.t0}
                             : GraphNode{at.position, NodeKind::crossing, 4, -1, 0};
  return subdivision.divide_arc(h, node, std::move(before), std::move(behind));
}

}  // namespace quadrille::graph
