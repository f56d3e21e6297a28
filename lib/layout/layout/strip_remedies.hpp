#pragma once
// What other nodes may resolve a strip of faces that contains itself: the integer lengths of such a T-mesh are zero
// (lib/method.md §9.6), and only critpoints, which chose the nodes, can change that.

#include <string>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/critical_points.hpp"

namespace quadrille::layout {

/// Options of critpoints, each to be tried alone and in this order, the most sparing first:
///   --corner-absorb 0          if a corner on the strip absorbed nodes
///   --ties field               if the valence of a corner on the strip was chosen at a tie
///   --place energy             if the strip has irregular nodes that may be moved
///   --corner-valence A:B=V     a corner on the strip emits a node, of valence 5 if it is reflex, else 3: V is one less
///                              or one more, and admissible; the four that add the least angle defect
///                              (guide/valence.hpp)
/// `strip_arcs`: the arcs along the strip (quantize::infeasibility_certificate); nodes at their ends lie on it.
std::vector<std::string> strip_remedies(const ArcGraph& t_mesh, const std::vector<int>& strip_arcs,
                                        const CriticalPoints& points);

}  // namespace quadrille::layout
