#pragma once
// Arcs that a solver sees as one: a periodic pair of curves consists of pairs of arcs, which must have the same nodes.
// Both sides of a crack are such a pair too, where the blocks beside them match.

#include <array>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/half_edge.hpp"

namespace quadrille::mesh {

/// Two half-edges along the boundary, the face on the left of each: a motion maps the first onto the second, reversed.
using PeriodicArcs = std::array<HalfEdge, 2>;

/// Both arcs of each pair, by the first arc; an arc without a counterpart is left out. Ends agree within 1e-6
/// diameters.
std::vector<PeriodicArcs> periodic_arcs(const ArcGraph& graph);

/// Throws ComputeError, with the position, if an arc on a periodic curve has no counterpart.
void require_periodic_arcs(const ArcGraph& graph);

}  // namespace quadrille::mesh
