#pragma once
// Paths along pieces of curves: reversed, joined, cut.

#include <utility>
#include <vector>

#include "curve/chain.hpp"
#include "model/arc_graph.hpp"

namespace quadrille::graph {

using Pieces = std::vector<ArcPiece>;

Pieces reversed_pieces(Pieces pieces);

/// The pieces of a half-edge, in its direction.
Pieces pieces_along(const ArcGraph& graph, HalfEdge h);

/// One path after the other; pieces that continue each other on one curve become one piece.
Pieces joined(Pieces first, const Pieces& second);

/// The part of a path before a point of it, and the part behind; neither has a piece of length zero at a joint.
std::pair<Pieces, Pieces> cut(const Pieces& pieces, const curve::ChainPoint& at);

}  // namespace quadrille::graph
