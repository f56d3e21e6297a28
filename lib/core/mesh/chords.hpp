#pragma once
// Sides of blocks, how they continue each other, and chords: strings of blocks.

#include <array>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/block_layout.hpp"
#include "model/periodic.hpp"

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

/// The chord of each of `num_arcs` arcs; chords are numbered by their first arc. `block2arcs` as in BlockLayout. An arc
/// that is not a side of a block is a chord of its own. If a chord crosses itself, all four sides of a block belong to
/// it.
/// `periodic`: pairs of arcs that belong to one chord as well.
std::vector<int> arc_chords(const std::vector<std::array<HalfEdge, 4>>& block2arcs, int num_arcs,
                            const std::vector<PeriodicArcs>& periodic = {});

/// A chord with its arcs, all in one direction, and the pairs of them that are opposite sides of a block.
struct Chord {
  std::vector<int> arcs;
  std::vector<bool> backwards;            ///< the arc's own direction is opposite to the chord's (its first arc's)
  std::vector<std::array<int, 2>> pairs;  ///< positions in `arcs`; a block that touches itself is not a pair
};

/// All chords, numbered as in `arc_chord`.
std::vector<Chord> directed_chords(const std::vector<std::array<HalfEdge, 4>>& block2arcs,
                                   const std::vector<int>& arc_chord, const std::vector<PeriodicArcs>& periodic = {});

}  // namespace quadrille::mesh
