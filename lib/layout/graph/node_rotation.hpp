#pragma once
// The order of half-edges around nodes, from the directions of their curves. A subdivision is built from it.

#include <vector>

#include "model/arc_graph.hpp"

namespace quadrille::graph {

/// Angle of a half-edge's tangent where it starts, radians in (-pi, pi].
double start_angle(const ArcGraph& graph, HalfEdge h);

/// Sorts half-edges that start at one node, counter-clockwise. On the boundary the first runs along the boundary with
/// the domain on its left and the last runs against it, independent of the rounding of their angles.
void sort_around_node(const ArcGraph& graph, std::vector<HalfEdge>& half_edges);

/// The sorted half-edges that start at each node.
std::vector<std::vector<HalfEdge>> half_edges_around_nodes(const ArcGraph& graph);

/// Quarter turns of the cross in the sectors between consecutive half-edges of a sorted, not empty list around `node`;
/// inside the domain the last sector lies between the last and the first. If all lines of the node are present, each
/// sector is one quarter; at a T-junction one sector is two quarters; else the valence is divided in proportion to the
/// angles.
std::vector<int> sector_quarters(const ArcGraph& graph, int node, const std::vector<HalfEdge>& half_edges);

}  // namespace quadrille::graph
