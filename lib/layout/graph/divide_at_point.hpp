#pragma once
// Divides an arc of a subdivision at a point of its curves.

#include "curve/chain.hpp"
#include "graph/subdivision.hpp"

namespace quadrille::graph {

/// Divides h at `at`, a point of the chain of pieces_along(h). The new node is a crossing, or lies on the boundary if
/// the arc does. A point within 1e-9 of a piece's parameter interval from a joint of two pieces is moved to the joint.
Subdivision::Division divide_at_point(Subdivision& subdivision, HalfEdge h, const curve::ChainPoint& at);

}  // namespace quadrille::graph
