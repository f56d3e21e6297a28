#pragma once
// Ends of arcs that go on from each other: beside a common node, on both sides of a third arc.

#include <vector>

#include "model/block_layout.hpp"

namespace quadrille::layers {

struct ArcEnd {
  int arc = 0;
  int end = 0;  ///< 0: from, 1: to
};

/// The intervals at `a` and `b` are neighbours across an arc between two blocks.
struct ArcNeighbours {
  ArcEnd a, b;
};

/// Both ends of every arc between two blocks, in the sequence of arcs. A block that meets itself is left out.
std::vector<ArcNeighbours> arc_neighbours(const BlockLayout& layout);

}  // namespace quadrille::layers
