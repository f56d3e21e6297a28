#pragma once
// Paths along pieces of curves: reversed, joined, cut; and arcs of a subdivision that are divided at a point of them.

#include <utility>
#include <vector>

#include "curve/chain.hpp"
#include "graph/subdivision.hpp"
#include "model/arc_graph.hpp"

namespace quadrille::graph {

using Pieces = std::vector<ArcPiece>;

/// Splines that are fitted to lines follow them within this, relative to the diameter.
inline constexpr double relative_fit_tol = 2e-9;

Pieces reversed_pieces(Pieces pieces);

/// The pieces of a half-edge, in its direction.
Pieces pieces_along(const ArcGraph& graph, HalfEdge h);

/// The path along a loop of the face from one node of it to another, or once around it from a node to itself.
Pieces boundary_path(const CadFace& face, const GraphNode& from, const GraphNode& to);

/// The point at a parameter on a piece of a path.
curve::ChainPoint point_on_piece(const ArcGraph& graph, const Pieces& pieces, std::size_t piece, double t);

/// One path after the other; pieces that continue each other on one curve become one piece.
Pieces joined(Pieces first, const Pieces& second);

/// The part of a path before a point of it, and the part behind; neither has a piece of length zero at a joint.
std::pair<Pieces, Pieces> cut(const Pieces& pieces, const curve::ChainPoint& at);

/// Divides h at `at`, a point of the chain of pieces_along(h). The new node is a crossing, or lies on the boundary if
/// the arc does. A point within 1e-9 of a piece's parameter interval from a joint of two pieces is moved to the joint.
Subdivision::Division divide_at_point(Subdivision& subdivision, HalfEdge h, const curve::ChainPoint& at);

}  // namespace quadrille::graph
