#include "graph/divide_at_point.hpp"

#include <cmath>

#include "graph/arc_pieces.hpp"

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
  GraphNode node{at.position, NodeKind::crossing, 4, -1, 0};
  if (const ArcPiece& piece = behind.front(); piece.curve < subdivision.graph().face.num_curves()) {
    const bool is_boundary = subdivision.graph().arcs[h.arc].is_boundary;
    node = {at.position, is_boundary ? NodeKind::boundary : NodeKind::interface, is_boundary ? 2 : 4, piece.curve,
            piece.t0};
  }
  return subdivision.divide_arc(h, node, std::move(before), std::move(behind));
}

}  // namespace quadrille::graph
