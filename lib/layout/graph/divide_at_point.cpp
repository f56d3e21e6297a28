#include "graph/divide_at_point.hpp"

#include <cmath>

#include "graph/arc_pieces.hpp"
#include "model/interfaces.hpp"

namespace quadrille::graph {
namespace {

constexpr double joint_tol = 1e-9;  // relative to a piece's parameter interval

// The parameter of a joint belongs to the piece behind it.
curve::ChainPoint moved_to_joint(const Pieces& pieces, curve::ChainPoint at) {
  const ArcPiece& piece = pieces[at.piece];
  const double tolerance = joint_tol * std::abs(piece.t1 - piece.t0);
  if (std::abs(at.t - piece.t1) <= tolerance && at.piece + 1 < static_cast<int>(pieces.size())) {
    at.t = pieces[++at.piece].t0;
  } else if (std::abs(at.t - piece.t0) <= tolerance && at.piece > 0) {
    at.t = piece.t0;
  }
  return at;
}

}  // namespace

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
