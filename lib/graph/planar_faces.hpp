#pragma once
// The faces of a separatrix graph: a walk over half-edges, and the census of corners that certifies the layout.
//
// A face is the cycle of half-edges that has it on the left. What lies outside the domain is no face.

#include <vector>

#include "model/half_edge.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// Angle at which a half-edge leaves its first node, radians in (-pi, pi].
double start_angle(const SeparatrixGraph& graph, HalfEdge h);

/// The half-edges that leave a node, counter-clockwise. On the boundary the first runs along the boundary with the
/// domain on its left and the last comes back along it, whatever the rounding of their angles.
std::vector<std::vector<HalfEdge>> half_edges_around_nodes(const SeparatrixGraph& graph);

struct PlanarFaces {
  /// Cycles of half-edges, each begun at its lowest arc number; sorted by it. In a domain whose graph is not connected
  /// the two sides of an annular face are two cycles.
  std::vector<std::vector<HalfEdge>> cycles;
  /// Quarter turns of the cross in the sector of the face at the END of each half-edge of each cycle.
  std::vector<std::vector<int>> quarters;
  int num_components = 0;  ///< of the graph; above 1 some face has a hole in it
};

/// Cost linear in the number of arcs, but for sorting around each node.
PlanarFaces planar_faces(const SeparatrixGraph& graph);

/// The corners of a cycle: sum of 2 - quarters.
int num_corners(const std::vector<int>& quarters);

/// The mean of the middles of a cycle's arcs, file coordinates: a place to look at.
Vec2 place_of(const SeparatrixGraph& graph, const std::vector<HalfEdge>& cycle);

/// The cycles that are no quadrilaterals: not four corners, or a node of two quarter turns on a side.
std::vector<int> cycles_without_four_corners(const PlanarFaces& faces);

/// Throws ComputeError unless every face has four corners; says how many have not, and where the first one lies.
/// Returns the number of faces.
int require_four_corners(const SeparatrixGraph& graph);

}  // namespace quadrille::graph
