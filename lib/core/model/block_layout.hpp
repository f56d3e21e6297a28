#pragma once
// The block decomposition (formats/block-layout.md, x.blocks.h5): a conforming set of four-sided blocks.
// A block is its four EXACT sides and their transfinite blend (lib/method.md §7); every side is one arc.
//
// Side k of a block runs from its node k to its node k+1 (mod 4), counter-clockwise. block2arcs contains the sides as
// half-edges that have the block on their left.

#include <array>
#include <string>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/provenance.hpp"

namespace quadrille {

struct BlockLayout : ArcGraph {
  Provenance provenance;
  std::vector<std::array<int, 4>> block2nodes;
  std::vector<std::array<HalfEdge, 4>> block2arcs;
  std::vector<int> arc_chord;                   ///< chord of each arc: the arcs of a chord are divided alike
  std::vector<double> block_jacobian_bound;     ///< least Bernstein bound of det J of the block as one quad of order 8
  std::vector<double> block_scaled_jacobian;    ///< least sampled value; -1 where det J <= 0; empty: not computed
  std::vector<double> block_boundary_distance;  ///< greatest, sides to CAD curves; empty: not computed
  std::vector<std::string> block_names;
  std::vector<int> unnamed_blocks;  ///< ascending: blocks without a given name; theirs is made from their number
  std::vector<int> block_region;    ///< region of each block; empty: there is one region

  int num_blocks() const { return static_cast<int>(block2nodes.size()); }
};

}  // namespace quadrille
