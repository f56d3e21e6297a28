#pragma once
// Opens interfaces of a layout: a crack has nodes of its own on both sides.
//
//       ccw side: arc a, its face on the left      The arc of an interface becomes two boundary arcs, one on each of
//     o==========================>o  tip           its curves. A node with open arcs is divided into one for each
//     o<==========================o  tip           sector between them: inside the curve into two, at a tip, where one
//       cw side: arc b, on the partner             open arc ends, into one. All positions are kept: the nodes of both
//                                                  sides lie in the same places.

#include <vector>

#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// Opens the interfaces on the curves of `is_open` (by curve; both sides alike) that the graph closes. Nodes and arcs
/// keep their numbers, new ones are numbered after them. Lines that cross an opened interface become two.
void open_interfaces(SeparatrixGraph& graph, const std::vector<bool>& is_open);

}  // namespace quadrille::graph
