#pragma once
// Strings of blocks: arcs linked through opposite sides of blocks share one count of elements.

#include <array>
#include <vector>

#include "model/half_edge.hpp"

namespace quadrille::mesh {

/// The chord of each of `num_arcs` arcs, numbered by their first arc. `block2arcs` as in BlockLayout. An arc that is no
/// block's side is a chord of its own. A chord may cross itself: then a block's four sides belong to one chord.
std::vector<int> arc_chords(const std::vector<std::array<HalfEdge, 4>>& block2arcs, int num_arcs);

/// A chord seen across: its arcs, all taken in one direction, and which of them are opposite sides of a block.
struct Chord {
  std::vector<int> arcs;
  std::vector<bool> backwards;            ///< the arc's own direction is against the chord's (its first arc's)
  std::vector<std::array<int, 2>> pairs;  ///< positions in `arcs`; a block that touches itself is no pair
};

/// All chords, numbered as in `arc_chord`.
std::vector<Chord> directed_chords(const std::vector<std::array<HalfEdge, 4>>& block2arcs,
                                   const std::vector<int>& arc_chord);

}  // namespace quadrille::mesh
