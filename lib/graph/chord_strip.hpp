#pragma once
// Chords of a separatrix graph as strips: blocks linked through opposite sides, walked from rung to rung.
//
//     left rail   l_0 ---- l_1 ---- l_2          Rung i runs from l_i to r_i; block i lies between rungs i and i + 1.
//                  | block  | block  |           Rungs lead from left to right, rails forwards.
//     right rail  r_0 ---- r_1 ---- r_2

#include <map>
#include <tuple>
#include <vector>

#include "graph/planar_faces.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

struct ChordStrip {
  std::vector<HalfEdge> rungs;        ///< one more than blocks; in a closed strip as many
  std::vector<HalfEdge> left, right;  ///< of each block
  std::vector<int> blocks;            ///< cycles of the PlanarFaces
  bool is_closed = false;
  bool crosses_itself = false;  ///< some block is met twice: the walk ends there
  double width = 0;             ///< mean length of the rungs
  double length = 0;            ///< mean length of the rails

  int num_blocks() const { return static_cast<int>(blocks.size()); }
  int next_rung(int i) const { return is_closed ? (i + 1) % num_blocks() : i + 1; }
  double slimness() const { return width / length; }
};

/// Length of each arc. `known` keeps those of pieces between calls for graphs whose splines keep their numbers.
struct PieceLengths {
  std::map<std::tuple<int, double, double>, double> known;
};
std::vector<double> arc_lengths(const SeparatrixGraph& graph, PieceLengths& pieces);
std::vector<double> arc_lengths(const SeparatrixGraph& graph);

/// The strip that holds an arc as a rung, without its width and length. Begins at the end with the lower arc number, a
/// closed one at its lowest arc. Every face must have four corners.
ChordStrip strip_through(const SeparatrixGraph& graph, const PlanarFaces& faces, int arc);

/// All strips, in the sequence of their lowest arcs; `lengths` of all arcs. Linear in the number of arcs.
std::vector<ChordStrip> all_strips(const SeparatrixGraph& graph, const PlanarFaces& faces,
                                   const std::vector<double>& lengths);

/// What a welded rung keeps in place.
enum class Pin { none, left, right };

/// A node that no weld may move: irregular inside, a corner, or irregular on the boundary.
bool is_fixed(const GraphNode& node);

/// The pin of each rung of a strip that can be collapsed, else empty. It can where every rung has at most one fixed
/// end, an inner rung at most one end on the boundary (which it keeps) and that end only where the other is not fixed;
/// where something is pinned at all; and where no node, and so no block or arc, belongs to it twice.
/// A regular node welded with one of valence V gives V, inside (V + 4 - 4) as on the boundary (V + 2 - 2).
std::vector<Pin> pins_of(const SeparatrixGraph& graph, const ChordStrip& strip);

}  // namespace quadrille::graph
