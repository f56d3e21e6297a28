#pragma once
// One graph of the whole face from the layouts of its regions.

#include "couple/region_layouts.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::couple {

/// Nodes of different regions nearer than 1e-8 diameters on an interface are one. Every interface is there once, as
/// arcs on the curves of its lower side; it is divided where a line of either side ends. A line that ends on an
/// interface between the lines of the other side ends in a T-junction. The valence of a node is the sum of those in the
/// sectors of its regions.
SeparatrixGraph join_layouts(const RegionLayouts& regions);

/// Moves the ends of splines to the nodes at which their arcs end, bit for bit.
void close_lines(SeparatrixGraph& graph);

}  // namespace quadrille::couple
