#pragma once
// Nodes of a layout on periodic sides, and their images.

#include "graph/candidate_layout.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::couple {

/// Moves nodes on second sides that are nearer than 1e-8 diameters to the image of a node on the first onto it.
void snap_periodic_nodes(SeparatrixGraph& graph);

/// Divides each side where the other one has a node, and both where a periodic side ends. Returns the number of new
/// nodes: T-junctions of the layout seen across its periodic sides.
int divide_periodic_sides(graph::CandidateLayout& layout);

}  // namespace quadrille::couple
