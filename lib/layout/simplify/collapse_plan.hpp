#pragma once
// Decides for each rung and each block of a collapsed strip which side is kept.
//
// Between fixed nodes of one side the rail of that side is kept; before the first and behind the last as well, so that
// a line keeps its end on the boundary. Between fixed nodes of different sides a blend replaces both rails
// (simplify/chord_blend.hpp): it starts at the one node and ends at the other.

#include <vector>

#include "graph/chord_strip.hpp"
#include "model/arc_graph.hpp"

namespace quadrille::simplify {

/// Blocks from a fixed node to the next one, which is on the other side.
struct BlendedStretch {
  int first_rung = 0, num_blocks = 0;
  bool from_left = true;  ///< the fixed node of the first rung
};

struct CollapsePlan {
  std::vector<graph::FixedSide> merged_into;  ///< of each rung: the end that is kept; none if a blend crosses it
  std::vector<graph::FixedSide> kept_rail;    ///< of each block; none: a blend replaces both
  std::vector<BlendedStretch> stretches;
};

/// `fixed` = graph::fixed_sides of the strip, not empty.
CollapsePlan plan_collapse(const graph::ChordStrip& strip, const std::vector<graph::FixedSide>& fixed);

/// Whether a rail that is not kept lies on the boundary.
bool removes_boundary(const ArcGraph& graph, const graph::ChordStrip& strip, const CollapsePlan& plan);

/// Number of rung `i` of a strip: in a closed strip they continue after the last with the first.
int wrapped_rung(const graph::ChordStrip& strip, int i);

}  // namespace quadrille::simplify
