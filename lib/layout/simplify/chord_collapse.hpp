#pragma once
// Collapses one chord of blocks of a layout: the two ends of each rung become one node, the two rails one line.
//
// Fixed nodes do not move; simplify/collapse_plan.hpp decides which rail is kept and which rails are blended. All lines
// that cross the strip keep their curves: where the new line crosses a rung, the arcs on both sides of the rung are
// lengthened by its parts. So only the blends deviate from the field, and every inner arc stays a part of one spline.

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "graph/chord_strip.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {

/// The blends that a strip needs. std::nullopt if one would deviate too far or replace a part of the boundary. `fixed`
/// = graph::fixed_sides(subdivision, strip), not empty, here and below.
std::optional<std::vector<Blend>> blends_of(const field::FieldsOfRegions& fields, const graph::Subdivision& subdivision,
                                            const graph::ChordStrip& strip, const std::vector<graph::FixedSide>& fixed,
                                            const BlendOptions& options);

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
/// one is missing or does not cross the rungs in order.
std::optional<ArcChanges> collapse_strip(graph::Subdivision& subdivision, const graph::ChordStrip& strip,
                                         const std::vector<graph::FixedSide>& fixed, const std::vector<Blend>& blends);

}  // namespace quadrille::simplify
