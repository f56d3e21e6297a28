#pragma once
// The block decomposition (formats/block-layout.md, x.blocks.h5): a conforming set of four-sided blocks.
// A block is its four EXACT sides and their transfinite blend (lib/method.md §7); every side is one arc.
//
// Side k of a block runs from its node k to its node k+1 (mod 4), counter-clockwise. block2arcs
// holds the sides as half-edges that have the block on their left.

#include <array>
#include <string>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/half_edge.hpp"
#include "model/provenance.hpp"

namespace quadrille {

struct BlockLayout : ArcGraph {
  Provenance provenance;
  std::vector<std::array<int, 4>> block2nodes;
  std::vector<std::array<HalfEdge, 4>> block2arcs;
  std::vector<int> arc_chord;                 ///< chord of each arc: arcs that share one count and one spacing
  std::vector<double> block_jacobian_bound;   ///< least Bernstein bound of det J of the block as one order-8 quad
  std::vector<double> block_scaled_jacobian;  ///< least of it, sampled; -1 where det J <= 0; empty: not known
  std::vector<double>
      block_boundary_distance;  ///< greatest distance of its sides from the CAD curves; empty: not known
  std::vector<std::string> block_names;
  std::vector<int> unnamed_blocks;  ///< ascending: nobody gave them a name, theirs is made from their number

  int num_blocks() const { return static_cast<int>(block2nodes.size()); }
};

}  // namespace quadrille
