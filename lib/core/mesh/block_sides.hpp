#pragma once
// Sides of blocks: the sides on an arc, the sides that continue each other along the boundary, and ends of arcs that
// continue each other at one node, on both sides of a third arc between two blocks.

#include <vector>

#include "model/block_layout.hpp"

namespace quadrille::mesh {

/// Side `side` (0 to 3, counter-clockwise) of a block; block -1: none.
struct BlockSide {
  int block = -1, side = 0;
};

/// The half-edge of a block's side; `side` is taken modulo 4.
HalfEdge half_edge(const BlockLayout& layout, int block, int side);

/// By arc: the sides that lie on it, by block and side.
using ArcSides = std::vector<std::vector<BlockSide>>;
ArcSides sides_of_arcs(const BlockLayout& layout);

/// The side on the boundary, or on an interface, that continues this one across the arc between their blocks (step +1:
/// at its end, -1: at its beginning); none at corners with a valence other than 2, nor where interfaces branch.
BlockSide next_along_boundary(const BlockLayout& layout, const ArcSides& arc_sides, const BlockSide& side, int step);

/// One end of an arc.
struct ArcEnd {
  int arc = 0;
  int end = 0;  ///< 0: from, 1: to
};

ArcEnd beginning(HalfEdge half_edge);  ///< the end of the arc at which the half-edge starts
ArcEnd ending(HalfEdge half_edge);     ///< the other end

/// The first intervals at `a` and `b` are neighbours.
struct ArcNeighbours {
  ArcEnd a, b;
};

/// Both ends of every arc between two blocks, ordered by arc. A block that meets itself has no neighbour there, and
/// none has one across an interface of two faces: sizes may jump there.
std::vector<ArcNeighbours> arc_neighbours(const BlockLayout& layout);

}  // namespace quadrille::mesh
