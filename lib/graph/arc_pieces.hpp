#pragma once
// Walks along pieces of curves: turned round, joined, cut.

#include <utility>
#include <vector>

#include "curve/chain.hpp"
#include "model/arc_graph.hpp"
#include "model/half_edge.hpp"

namespace quadrille::graph {

using Pieces = std::vector<ArcPiece>;

Pieces reversed_pieces(Pieces pieces);

/// Of a half-edge, in its direction.
Pieces pieces_along(const ArcGraph& graph, HalfEdge h);

/// One walk after the other; where the curve goes on, as one piece.
Pieces joined(Pieces first, const Pieces& second);

/// The part of a walk before a point of it, and the part behind.
std::pair<Pieces, Pieces> cut(const Pieces& pieces, const curve::ChainPoint& at);

}  // namespace quadrille::graph
