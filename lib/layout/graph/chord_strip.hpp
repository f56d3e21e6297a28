#pragma once
// Chords of a conforming subdivision as strips: blocks linked through opposite sides, followed from rung to rung.
//
//     left rail   l_0 ---- l_1 ---- l_2          Rung i runs from l_i to r_i; block i lies between rungs i and i + 1.
//                  | block  | block  |           Rungs lead from left to right, rails forwards.
//     right rail  r_0 ---- r_1 ---- r_2

#include <vector>

#include "curve/chain.hpp"
#include "graph/subdivision.hpp"

namespace quadrille::graph {

struct ChordStrip {
  std::vector<HalfEdge> rungs;        ///< one more than blocks; in a closed strip as many
  std::vector<HalfEdge> left, right;  ///< of each block
  std::vector<int> blocks;            ///< faces of the subdivision
  bool is_closed = false;
  bool crosses_itself = false;  ///< some block occurs twice: the strip ends there
  double width = 0;             ///< mean length of the rungs
  double length = 0;            ///< mean length of the rails

  int num_blocks() const { return static_cast<int>(blocks.size()); }
  double aspect() const { return width / length; }
};

/// Length of each arc.
std::vector<double> arc_lengths(const ArcGraph& graph);
/// `table`: of the curves of the arc's graph.
double arc_length(const curve::CurveTable& table, const GraphArc& arc);

/// The strip that has an arc as a rung, without its width and length. Begins at the end with the lower arc number, a
/// closed one at its lowest arc. Every face must have four corners.
ChordStrip strip_through(const Subdivision& subdivision, int arc);

/// The same with its width and length; `lengths` of all arcs.
ChordStrip measured_strip(const Subdivision& subdivision, int arc, const std::vector<double>& lengths);

/// All strips, ordered by their lowest arcs; `lengths` of all arcs. Linear in the number of arcs.
std::vector<ChordStrip> all_strips(const Subdivision& subdivision, const std::vector<double>& lengths);

/// Whether the strip ends on a periodic side: it goes on beyond, so that it cannot be collapsed alone.
bool ends_on_periodic_side(const Subdivision& subdivision, const ChordStrip& strip);

/// The side of a strip on which a rung's end does not move when the rung is shrunk to a point.
enum class FixedSide { none, left, right };

/// A node that no collapse may move: irregular inside, a corner, or irregular on the boundary.
bool is_fixed(const GraphNode& node);

/// The fixed side of each rung of a strip that can be collapsed, else empty. Conditions: every rung has at most one
/// fixed end; an inner rung has at most one end on the boundary (which it keeps), and only if the other end is not
/// fixed; at least one end is fixed; no node, and so no block or arc, belongs to the strip twice. A regular node merged
/// with one of valence V results in V, inside (V + 4 - 4) as on the boundary (V + 2 - 2).
std::vector<FixedSide> fixed_sides(const Subdivision& subdivision, const ChordStrip& strip);

}  // namespace quadrille::graph
