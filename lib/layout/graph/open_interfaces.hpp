#pragma once
// Interfaces and slits that are open: nothing crosses them, and each side has nodes of its own.
//
//       ccw side: arc a, its face on the left      The arc of an interface becomes two boundary arcs, one on each of
//     o==========================>o  tip           its curves. A node with open arcs is divided into one for each
//     o<==========================o  tip           sector between them: inside the curve into two, at a tip, where one
//       cw side: arc b, on the partner             open arc ends, into one. All positions are kept: the nodes of both
//                                                  sides lie in the same places.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

/// The face without the partners of the interfaces and slits of these names. Throws UsageError, which begins with
/// `option`, if a name is that of no curve, or of a curve without a partner.
CadFace with_open_curves(CadFace face, const std::vector<std::string>& names, const std::string& option);

/// The names of options NAME=nonconforming. Throws UsageError for others.
std::vector<std::string> nonconforming_interfaces(const std::vector<std::string>& options);

/// Opens the interfaces of a layout on the curves of `is_open` (by curve; both sides alike) that the graph closes.
/// Nodes and arcs keep their numbers, new ones are numbered after them. Lines that cross an opened interface become
/// two.
void open_interfaces(SeparatrixGraph& graph, const std::vector<bool>& is_open);

}  // namespace quadrille::graph
