#pragma once
// Chords (strings of blocks): arcs linked through opposite sides of blocks have the same number of elements.

#include <array>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/periodic.hpp"

namespace quadrille::mesh {

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
