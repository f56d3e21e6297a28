#pragma once
// Ends of arcs that continue each other: at one node, on both sides of a third arc between two blocks.

#include <vector>

#include "mesh/block_sides.hpp"
#include "model/block_layout.hpp"

namespace quadrille::mesh {

/// The first intervals at `a` and `b` are neighbours.
struct ArcNeighbours {
  ArcEnd a, b;
};

/// Both ends of every arc between two blocks, ordered by arc. A block that meets itself has no neighbour there, and
/// none has one across an interface of two faces: sizes may jump there.
std::vector<ArcNeighbours> arc_neighbours(const BlockLayout& layout);

}  // namespace quadrille::mesh
