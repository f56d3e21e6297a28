#pragma once
// Splits the arcs of a T-mesh at their crossings with iso-lines.

#include <map>
#include <utility>
#include <vector>

#include "curve/chain.hpp"
#include "quantize/quantized_parametrization.hpp"

namespace quadrille::quantize {

struct SplitArcs {
  std::vector<std::vector<int>> parts;  ///< of each arc of the T-mesh: arcs of the graph, in its direction
  std::map<std::pair<int, int>, int> node_of_crossing;  ///< by arc of the T-mesh and number of the point
};

/// Appends the parts of all arcs, and a node for each crossing, to `graph`, whose nodes and curves must be the nodes
/// and curves of the T-mesh. `chains`: of the arcs.
SplitArcs split_arcs(const ArcGraph& t_mesh, const std::vector<curve::Chain>& chains,
                     const CrossingFractions& fractions, SeparatrixGraph& graph);

}  // namespace quadrille::quantize
