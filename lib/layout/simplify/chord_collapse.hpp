#pragma once
// Collapses one chord of blocks of a layout: the two ends of each rung become one node, the two rails one line.
//
// Fixed nodes do not move. Between fixed nodes of one side the rail of that side is kept; before the first and behind
// the last as well, so that a line keeps its end on the boundary. Between fixed nodes of different sides a blend
// replaces both rails (simplify/chord_blend.hpp): it starts at the one node and ends at the other. All lines that cross
// the strip keep their curves: where the new line crosses a rung, the arcs on both sides of the rung are lengthened by
// its parts. So only the blends deviate from the field, and every inner arc stays a part of one spline.

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "graph/chord_strip.hpp"
#include "simplify/chord_blend.hpp"

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

/// The blends that a strip needs. std::nullopt if it cannot be collapsed (graph::fixed_sides), or if one would deviate
/// too far or replace a part of the boundary.
std::optional<std::vector<Blend>> blends_of(const field::FieldsOfRegions& fields, const graph::Subdivision& subdivision,
                                            const graph::ChordStrip& strip, const BlendOptions& options);

/// What collapses change. Arcs that are not removed keep their numbers.
struct ArcChanges {
  std::map<int, int> removed;  ///< with the arc that takes its place: for a rail the other rail, for a rung -1
  std::set<int> changed;       ///< whose shape has changed

  /// The arc that has taken the place of an arc, itself if it was not removed; -1 if none has.
  int now(int arc) const;
  /// Adds changes after these.
  void add(const ArcChanges& later);
};

/// Collapses a strip. `blends` must include those of the strip. They may have been computed before other strips that
/// cross it were collapsed, so the result does not depend on the order of strips. std::nullopt, without any change, if
/// the strip cannot be collapsed, or if a blend is missing or does not cross the rungs in order.
std::optional<ArcChanges> collapse_strip(graph::Subdivision& subdivision, const graph::ChordStrip& strip,
                                         const std::vector<Blend>& blends);

}  // namespace quadrille::simplify
